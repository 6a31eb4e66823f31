/* What a C programmer would write for the basis of Eqs. (29) and (30): 16 functions of v and t, each with its derivatives
   vv, vvvv, t and tt, at blocks of points. The functions are evaluated in loops of their own, which lets the compiler use
   the vector library; in one loop it pairs sines with cosines and calls the scalar one.

   Prints nanoseconds a point: all 80 values stored (`values`), and one weighted sum of them (`sum`). */
#define _POSIX_C_SOURCE 199309L
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#ifndef BLOCK
#define BLOCK 64
#endif
#define STRIDE (BLOCK + 8) /* rows a power of two apart would share a few sets of the first-level cache */
#define POINTS 131072
#define ROUNDS 31

static const double a1 = 1.3, a2 = 0.4, a3 = 2.0, a4 = 0.8, a5 = 3.0;
static double weights[80];
static double functions[8][BLOCK];

static void evaluate_functions(const double *restrict v) {
    for (int i = 0; i < BLOCK; i++) functions[0][i] = sinh(a1 * v[i] + a2);
    for (int i = 0; i < BLOCK; i++) functions[1][i] = cosh(a4 * v[i]);
    for (int i = 0; i < BLOCK; i++) functions[2][i] = sin(a3 * v[i]);
    for (int i = 0; i < BLOCK; i++) functions[3][i] = cos(a3 * v[i]);
    for (int i = 0; i < BLOCK; i++) functions[4][i] = sin(a5 * v[i]);
    for (int i = 0; i < BLOCK; i++) functions[5][i] = cos(a5 * v[i]);
    for (int i = 0; i < BLOCK; i++) functions[6][i] = sin(v[i]);
    for (int i = 0; i < BLOCK; i++) functions[7][i] = cos(v[i]);
}

/* `put(row, value)` for the five values of 1 and t, of f and t f for six functions, of t f for the last two. */
#define EVERY_VALUE(put)                                                                                                \
    put(0, 1.0) put(1, 0.0) put(2, 0.0) put(3, 0.0) put(4, 0.0)                                                         \
    put(5, time) put(6, 0.0) put(7, 0.0) put(8, 1.0) put(9, 0.0)                                                        \
    BOTH(put, 10, functions[0][i], a1 * a1) BOTH(put, 20, functions[1][i], a4 * a4)                                     \
    BOTH(put, 30, functions[2][i], -a3 * a3) BOTH(put, 40, functions[3][i], -a3 * a3)                                   \
    BOTH(put, 50, functions[4][i], -a5 * a5) BOTH(put, 60, functions[5][i], -a5 * a5)                                   \
    MOVING(put, 70, functions[6][i], -1.0) MOVING(put, 75, functions[7][i], -1.0)
#define BOTH(put, row, f, q)                                                                                            \
    put(row, f) put(row + 1, (q) * f) put(row + 2, (q) * (q) * f) put(row + 3, 0.0) put(row + 4, 0.0)                   \
    MOVING(put, row + 5, f, q)
#define MOVING(put, row, f, q)                                                                                          \
    put(row, time * f) put(row + 1, (q) * (time * f)) put(row + 2, (q) * (q) * (time * f)) put(row + 3, f)              \
    put(row + 4, 0.0)

__attribute__((noinline)) static void values(const double *restrict v, const double *restrict t, double *restrict out) {
    evaluate_functions(v);
    for (int i = 0; i < BLOCK; i++) {
        const double time = t[i];
#define STORE(row, value) out[(size_t)(row) * STRIDE + i] = (value);
        EVERY_VALUE(STORE)
    }
}

__attribute__((noinline)) static void sum(const double *restrict v, const double *restrict t, double *restrict out) {
    evaluate_functions(v);
    for (int i = 0; i < BLOCK; i++) {
        const double time = t[i];
        double sums[4] = {0, 0, 0, 0};
#define ADD(row, value) sums[(row) % 4] += weights[row] * (value);
        EVERY_VALUE(ADD)
        out[i] = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    }
}

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static double number(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

int main(void) {
    double *v = aligned_alloc(64, sizeof(double) * POINTS), *t = aligned_alloc(64, sizeof(double) * POINTS);
    double *out = aligned_alloc(64, sizeof(double) * (80 * STRIDE + POINTS));
    if (!v || !t || !out) return 1;
    uint64_t state = 1;
    for (int i = 0; i < POINTS; i++) v[i] = 6.283185307179586 * number(&state), t[i] = number(&state);
    for (int row = 0; row < 80; row++) weights[row] = 1.0 / (row + 3);
    double fastest[2] = {1e9, 1e9};
    for (int round = 0; round < ROUNDS; round++) {
        double begin = now();
        for (int i = 0; i < POINTS; i += BLOCK) values(v + i, t + i, out);
        double middle = now();
        for (int i = 0; i < POINTS; i += BLOCK) sum(v + i, t + i, out + i);
        double end = now();
        fastest[0] = fmin(fastest[0], middle - begin), fastest[1] = fmin(fastest[1], end - middle);
    }
    printf("values %.17g\nsum %.17g\n", 1e9 * fastest[0] / POINTS, 1e9 * fastest[1] / POINTS);
    return 0;
}
