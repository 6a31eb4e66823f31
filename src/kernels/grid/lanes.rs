//! Vectors of several widths behind one trait, so that a kernel over tiles is written once.
//!
//! Tiles are held in registers by hand, because the compiler keeps arrays of that size in memory.

/// A floating-point number that grids are made of.
pub trait Number: Copy + Default + PartialOrd + Send + Sync + 'static {
    /// The vectors of AVX-512.
    #[cfg(target_arch = "x86_64")]
    type Avx512: Lanes<Number = Self>;
    /// The vectors of AVX2.
    #[cfg(target_arch = "x86_64")]
    type Avx2: Lanes<Number = Self>;
    /// Vectors that need no particular instructions.
    type Baseline: Lanes<Number = Self>;

    /// Numbers up to this size are finite, with room for roundings.
    const LARGEST: f64;
    /// Fourth powers of numbers up to this size are finite, and sums of a dozen of them.
    const MODERATE: f64;

    /// The nearest number to a double.
    fn rounded(x: f64) -> Self;
    /// The same number as a double.
    fn to_f64(self) -> f64;
}

macro_rules! number {
    ($number:ident, $avx512:ident, $avx2:ident, $lanes:literal, $moderate:literal) => {
        impl Number for $number {
            #[cfg(target_arch = "x86_64")]
            type Avx512 = std::arch::x86_64::$avx512;
            #[cfg(target_arch = "x86_64")]
            type Avx2 = std::arch::x86_64::$avx2;
            type Baseline = [$number; $lanes];

            const LARGEST: f64 = 0.5 * $number::MAX as f64;
            const MODERATE: f64 = $moderate;

            #[inline(always)]
            fn rounded(x: f64) -> $number {
                x as $number
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }
    };
}

number!(f64, __m512d, __m256d, 2, 1e75);
number!(f32, __m512, __m256, 4, 1e9);

/// Some numbers in one register.
///
/// # Safety
/// Every method may be called only where the processor has the instructions that the implementing type is named for,
/// and is to be inlined into a function compiled for them.
pub unsafe trait Lanes: Copy {
    /// What there are several of.
    type Number: Number;
    /// How many numbers.
    const COUNT: usize;
    /// Whether 32 registers can be had, and not 16.
    const HAS_MANY: bool;

    /// The same number everywhere.
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
    /// The smaller; either where they do not compare.
    unsafe fn min(self, b: Self) -> Self;
    /// From all x, all y and all z to x y z x y z …
    unsafe fn interleaved(xyz: [Self; 3]) -> [Self; 3];
}

macro_rules! lanewise {
    ($a:expr, $b:expr, $c:expr, $lanes:literal, $function:expr) => {{
        let mut result = [0.0; $lanes];
        for (slot, ((a, b), c)) in result.iter_mut().zip($a.into_iter().zip($b).zip($c)) {
            *slot = $function(a, b, c);
        }
        result
    }};
}

macro_rules! portable_lanes {
    ($number:ident, $lanes:literal) => {
        // SAFETY: needs no instructions that not every processor of the target has.
        unsafe impl Lanes for [$number; $lanes] {
            type Number = $number;
            const COUNT: usize = $lanes;
            const HAS_MANY: bool = false;

            #[inline(always)]
            unsafe fn splat(x: $number) -> Self {
                [x; $lanes]
            }
            #[inline(always)]
            unsafe fn load(from: *const $number) -> Self {
                // SAFETY: the caller has so many numbers at the address; an array is aligned as one of them.
                unsafe { from.cast::<Self>().read() }
            }
            #[inline(always)]
            unsafe fn store(self, to: *mut $number) {
                // SAFETY: as above, and they may be written.
                unsafe { to.cast::<Self>().write(self) }
            }
            #[inline(always)]
            unsafe fn stream(self, to: *mut $number) {
                // SAFETY: as above.
                unsafe { to.cast::<Self>().write(self) }
            }
            #[inline(always)]
            unsafe fn mul_add(self, b: Self, c: Self) -> Self {
                lanewise!(self, b, c, $lanes, $number::mul_add)
            }
            #[inline(always)]
            unsafe fn mul(self, b: Self) -> Self {
                lanewise!(self, b, b, $lanes, |x: $number, y: $number, _| x * y)
            }
            #[inline(always)]
            unsafe fn mul_sub(self, b: Self, c: Self) -> Self {
                lanewise!(self, b, c, $lanes, |x: $number, y: $number, z: $number| x.mul_add(y, -z))
            }
            #[inline(always)]
            unsafe fn inverse_root(self) -> Self {
                lanewise!(self, self, self, $lanes, |x: $number, _, _| 1.0 / x.sqrt())
            }
            #[inline(always)]
            unsafe fn min(self, b: Self) -> Self {
                lanewise!(self, b, b, $lanes, |x: $number, y: $number, _| if x < y { x } else { y })
            }
            #[inline(always)]
            unsafe fn interleaved([x, y, z]: [Self; 3]) -> [Self; 3] {
                let mut together = [[0.0; $lanes]; 3];
                let points = x.into_iter().zip(y).zip(z).flat_map(|((x, y), z)| [x, y, z]);
                for (slot, number) in together.as_flattened_mut().iter_mut().zip(points) {
                    *slot = number;
                }
                together
            }
        }
    };
}

portable_lanes!(f64, 2);
portable_lanes!(f32, 4);

#[cfg(target_arch = "x86_64")]
mod x86 {
    use std::arch::x86_64::*;

    use super::Lanes;

    macro_rules! x86_lanes {
        ($vector:ident of $count:literal $number:ident: $splat:ident $load:ident $store:ident $stream:ident $fmadd:ident
            $fmsub:ident $mul:ident $div:ident $sqrt:ident $min:ident, $has_many:literal, $interleaved:expr) => {
            // SAFETY: the instructions are those of the vector's name, and with AVX2 those of FMA.
            unsafe impl Lanes for $vector {
                type Number = $number;
                const COUNT: usize = $count;
                const HAS_MANY: bool = $has_many;

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
                unsafe fn min(self, b: Self) -> Self {
                    // SAFETY: as for `splat`.
                    unsafe { $min(self, b) }
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
        _mm512_fmsub_pd _mm512_mul_pd _mm512_div_pd _mm512_sqrt_pd _mm512_min_pd, true, interleaved_8);
    x86_lanes!(__m512 of 16 f32: _mm512_set1_ps _mm512_loadu_ps _mm512_storeu_ps _mm512_stream_ps _mm512_fmadd_ps
        _mm512_fmsub_ps _mm512_mul_ps _mm512_div_ps _mm512_sqrt_ps _mm512_min_ps, true, interleaved_16);
    x86_lanes!(__m256d of 4 f64: _mm256_set1_pd _mm256_loadu_pd _mm256_storeu_pd _mm256_stream_pd _mm256_fmadd_pd
        _mm256_fmsub_pd _mm256_mul_pd _mm256_div_pd _mm256_sqrt_pd _mm256_min_pd, false, through_memory::<__m256d, 4, 12>);
    x86_lanes!(__m256 of 8 f32: _mm256_set1_ps _mm256_loadu_ps _mm256_storeu_ps _mm256_stream_ps _mm256_fmadd_ps
        _mm256_fmsub_ps _mm256_mul_ps _mm256_div_ps _mm256_sqrt_ps _mm256_min_ps, false, through_memory::<__m256, 8, 24>);

    /// For vector o of the result, where lane l comes from: first from x and y together, then from that and z.
    macro_rules! shuffles {
        ($name:ident, $index:ident, $count:literal) => {
            #[allow(
                clippy::indexing_slicing,
                reason = "runs in the compiler, to which an index out of range is an error"
            )]
            const fn $name() -> [[[$index; $count]; 2]; 3] {
                let mut all = [[[0; $count]; 2]; 3];
                let mut flat = 0;
                while flat < 3 * $count {
                    let (o, l, from) = (flat / $count, flat % $count, (flat / 3) as $index);
                    let [first, second] = &mut all[o];
                    first[l] = if flat % 3 == 1 { from + $count } else { from };
                    second[l] = if flat % 3 == 2 { from + $count } else { l as $index };
                    flat += 1;
                }
                all
            }
        };
    }

    shuffles!(shuffles_8, i64, 8);
    shuffles!(shuffles_16, i32, 16);

    #[inline(always)]
    unsafe fn interleaved_8([x, y, z]: [__m512d; 3]) -> [__m512d; 3] {
        const SHUFFLES: [[[i64; 8]; 2]; 3] = shuffles_8();
        let [a, b, c] = &SHUFFLES;
        // Not in a closure, which would be compiled without the instructions.
        macro_rules! shuffled {
            ($indices:ident) => {{
                let [first, second] = $indices;
                // SAFETY: an index vector has the size of its array; the processor has AVX-512.
                unsafe {
                    let xy = _mm512_permutex2var_pd(x, _mm512_loadu_epi64(first.as_ptr()), y);
                    _mm512_permutex2var_pd(xy, _mm512_loadu_epi64(second.as_ptr()), z)
                }
            }};
        }
        [shuffled!(a), shuffled!(b), shuffled!(c)]
    }

    #[inline(always)]
    unsafe fn interleaved_16([x, y, z]: [__m512; 3]) -> [__m512; 3] {
        const SHUFFLES: [[[i32; 16]; 2]; 3] = shuffles_16();
        let [a, b, c] = &SHUFFLES;
        macro_rules! shuffled {
            ($indices:ident) => {{
                let [first, second] = $indices;
                // SAFETY: as above.
                unsafe {
                    let xy = _mm512_permutex2var_ps(x, _mm512_loadu_epi32(first.as_ptr()), y);
                    _mm512_permutex2var_ps(xy, _mm512_loadu_epi32(second.as_ptr()), z)
                }
            }};
        }
        [shuffled!(a), shuffled!(b), shuffled!(c)]
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
        let [first, second, third] = [0, N, 2 * N].map(|o| together.as_ptr().wrapping_add(o));
        // SAFETY: N3 is three times the number of lanes.
        unsafe { [L::load(first), L::load(second), L::load(third)] }
    }
}
