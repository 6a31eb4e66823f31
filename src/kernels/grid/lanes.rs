//! Vectors of several widths behind one trait, so that a kernel over tiles is written once.
//!
//! Tiles are held in registers by hand, because the compiler keeps arrays of that size in memory.

/// A floating-point number that grids are made of.
pub trait Number: Copy + Default + PartialOrd + Send + Sync {
    /// The nearest number to a double.
    fn rounded(x: f64) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn rounded(x: f64) -> f64 {
        x
    }
}

impl Number for f32 {
    #[inline(always)]
    fn rounded(x: f64) -> f32 {
        x as f32
    }
}

/// Some numbers in one register.
///
/// # Safety
/// Every method may be called only where the processor has the instructions that the implementing type is named for,
/// and is to be inlined into a function compiled for them.
pub(super) unsafe trait Lanes: Copy {
    type Number: Number;
    /// How many numbers.
    const COUNT: usize;

    unsafe fn splat(x: Self::Number) -> Self;
    /// Reads `COUNT` numbers from an address aligned as one of them.
    unsafe fn load(from: *const Self::Number) -> Self;
    /// Writes `COUNT` numbers to an address aligned as one of them.
    unsafe fn store(self, to: *mut Self::Number);
    /// Writes past the caches, to an address aligned to all the numbers together.
    unsafe fn stream(self, to: *mut Self::Number);
    /// `self * b + c`, rounded once.
    unsafe fn mul_add(self, b: Self, c: Self) -> Self;
    /// `self * b`
    unsafe fn mul(self, b: Self) -> Self;
    /// `self * b - c`, rounded once.
    unsafe fn mul_sub(self, b: Self, c: Self) -> Self;
    /// `1 / sqrt(self)`, rounded twice.
    unsafe fn inverse_root(self) -> Self;
    /// From all x, all y and all z to x y z x y z …
    unsafe fn interleaved(xyz: [Self; 3]) -> [Self; 3];
}

macro_rules! scalar_lanes {
    ($number:ident) => {
        // SAFETY: needs no instructions that not every processor of the target has.
        unsafe impl Lanes for $number {
            type Number = $number;
            const COUNT: usize = 1;

            #[inline(always)]
            unsafe fn splat(x: $number) -> Self {
                x
            }
            #[inline(always)]
            unsafe fn load(from: *const $number) -> Self {
                // SAFETY: the caller's address is that of a number.
                unsafe { from.read() }
            }
            #[inline(always)]
            unsafe fn store(self, to: *mut $number) {
                // SAFETY: as above, and it may be written.
                unsafe { to.write(self) }
            }
            #[inline(always)]
            unsafe fn stream(self, to: *mut $number) {
                // SAFETY: as above.
                unsafe { to.write(self) }
            }
            #[inline(always)]
            unsafe fn mul_add(self, b: Self, c: Self) -> Self {
                $number::mul_add(self, b, c)
            }
            #[inline(always)]
            unsafe fn mul(self, b: Self) -> Self {
                self * b
            }
            #[inline(always)]
            unsafe fn mul_sub(self, b: Self, c: Self) -> Self {
                $number::mul_add(self, b, -c)
            }
            #[inline(always)]
            unsafe fn inverse_root(self) -> Self {
                1.0 / self.sqrt()
            }
            #[inline(always)]
            unsafe fn interleaved(xyz: [Self; 3]) -> [Self; 3] {
                xyz
            }
        }
    };
}

scalar_lanes!(f64);
scalar_lanes!(f32);

#[cfg(target_arch = "x86_64")]
mod x86 {
    use std::arch::x86_64::*;

    use super::Lanes;

    macro_rules! x86_lanes {
        ($vector:ident of $count:literal $number:ident: $splat:ident $load:ident $store:ident $stream:ident $fmadd:ident
            $fmsub:ident $mul:ident $div:ident $sqrt:ident, $interleaved:expr) => {
            // SAFETY: the instructions are those of the vector's name, and with AVX2 those of FMA.
            unsafe impl Lanes for $vector {
                type Number = $number;
                const COUNT: usize = $count;

                #[inline(always)]
                unsafe fn splat(x: $number) -> Self {
                    // SAFETY: the caller's processor has the instruction; likewise below.
                    unsafe { $splat(x) }
                }
                #[inline(always)]
                unsafe fn load(from: *const $number) -> Self {
                    // SAFETY: and there are `COUNT` numbers at the address.
                    unsafe { $load(from) }
                }
                #[inline(always)]
                unsafe fn store(self, to: *mut $number) {
                    // SAFETY: and `COUNT` numbers may be written at the address.
                    unsafe { $store(to, self) }
                }
                #[inline(always)]
                unsafe fn stream(self, to: *mut $number) {
                    // SAFETY: and the address is aligned to them.
                    unsafe { $stream(to, self) }
                }
                #[inline(always)]
                unsafe fn mul_add(self, b: Self, c: Self) -> Self {
                    // SAFETY: as for `splat`.
                    unsafe { $fmadd(self, b, c) }
                }
                #[inline(always)]
                unsafe fn mul(self, b: Self) -> Self {
                    // SAFETY: as for `splat`.
                    unsafe { $mul(self, b) }
                }
                #[inline(always)]
                unsafe fn mul_sub(self, b: Self, c: Self) -> Self {
                    // SAFETY: as for `splat`.
                    unsafe { $fmsub(self, b, c) }
                }
                #[inline(always)]
                unsafe fn inverse_root(self) -> Self {
                    // SAFETY: as for `splat`.
                    unsafe { $div($splat(1.0), $sqrt(self)) }
                }
                #[inline(always)]
                unsafe fn interleaved(xyz: [Self; 3]) -> [Self; 3] {
                    // SAFETY: as for `splat`.
                    unsafe { $interleaved(xyz) }
                }
            }
        };
    }

    x86_lanes!(__m512d of 8 f64: _mm512_set1_pd _mm512_loadu_pd _mm512_storeu_pd _mm512_stream_pd _mm512_fmadd_pd
        _mm512_fmsub_pd _mm512_mul_pd _mm512_div_pd _mm512_sqrt_pd, interleaved_8);
    x86_lanes!(__m512 of 16 f32: _mm512_set1_ps _mm512_loadu_ps _mm512_storeu_ps _mm512_stream_ps _mm512_fmadd_ps
        _mm512_fmsub_ps _mm512_mul_ps _mm512_div_ps _mm512_sqrt_ps, interleaved_16);
    x86_lanes!(__m256d of 4 f64: _mm256_set1_pd _mm256_loadu_pd _mm256_storeu_pd _mm256_stream_pd _mm256_fmadd_pd
        _mm256_fmsub_pd _mm256_mul_pd _mm256_div_pd _mm256_sqrt_pd, through_memory::<__m256d, 4, 12>);
    x86_lanes!(__m256 of 8 f32: _mm256_set1_ps _mm256_loadu_ps _mm256_storeu_ps _mm256_stream_ps _mm256_fmadd_ps
        _mm256_fmsub_ps _mm256_mul_ps _mm256_div_ps _mm256_sqrt_ps, through_memory::<__m256, 8, 24>);

    /// For vector o of the result, where lane l comes from: first from x and y together, then from that and z.
    const fn shuffles<const N: usize>() -> [[[i64; N]; 2]; 3] {
        let mut all = [[[0; N]; 2]; 3];
        let mut flat = 0;
        while flat < 3 * N {
            let (o, l, from) = (flat / N, flat % N, (flat / 3) as i64);
            let [first, second] = &mut all[o];
            first[l] = if flat % 3 == 1 { from + N as i64 } else { from };
            second[l] = if flat % 3 == 2 { from + N as i64 } else { l as i64 };
            flat += 1;
        }
        all
    }

    #[inline(always)]
    unsafe fn interleaved_8([x, y, z]: [__m512d; 3]) -> [__m512d; 3] {
        const SHUFFLES: [[[i64; 8]; 2]; 3] = shuffles();
        SHUFFLES.map(|[first, second]| {
            // SAFETY: an index vector has the size of its array; the processor has AVX-512.
            unsafe {
                let [first, second] = [first, second].map(|indices| _mm512_loadu_epi64(indices.as_ptr()));
                _mm512_permutex2var_pd(_mm512_permutex2var_pd(x, first, y), second, z)
            }
        })
    }

    #[inline(always)]
    unsafe fn interleaved_16([x, y, z]: [__m512; 3]) -> [__m512; 3] {
        const SHUFFLES: [[[i64; 16]; 2]; 3] = shuffles();
        SHUFFLES.map(|indices| {
            let [first, second] = indices.map(|indices| indices.map(|index| index as i32));
            // SAFETY: an index vector has the size of its array; the processor has AVX-512.
            unsafe {
                let [first, second] = [first, second].map(|indices| _mm512_loadu_epi32(indices.as_ptr()));
                _mm512_permutex2var_ps(_mm512_permutex2var_ps(x, first, y), second, z)
            }
        })
    }

    #[inline(always)]
    unsafe fn through_memory<L: Lanes, const N: usize, const N3: usize>(xyz: [L; 3]) -> [L; 3] {
        let mut apart = [[L::Number::default(); N]; 3];
        let mut together = [L::Number::default(); N3];
        for (vector, numbers) in xyz.into_iter().zip(&mut apart) {
            // SAFETY: N is the number of lanes.
            unsafe { vector.store(numbers.as_mut_ptr()) };
        }
        let [x, y, z] = &apart;
        for (point, ((x, y), z)) in together.chunks_exact_mut(3).zip(x.iter().zip(y).zip(z)) {
            point.copy_from_slice(&[*x, *y, *z]);
        }
        // SAFETY: N3 is three times the number of lanes.
        [0, 1, 2].map(|o| unsafe { L::load(together.as_ptr().add(o * N)) })
    }
}
