//! Compiles a program to machine code with Cranelift.
//!
//! Input: a [`Program`]; output: an evaluator that owns the code. The code is one function: uniform ops, then a
//! loop over samples with the varying ops in program order. It uses addition, subtraction, multiplication,
//! division, square root and negation of doubles, each rounded as the interpreter's, and calls of the operator
//! table: no fused operations, so both evaluators agree bit for bit.
//!
//! Invariants: the code reads and writes nothing but the slices of one [`Evaluator::evaluate`] call, whose lengths
//! are checked before; it calls by absolute address, so there is no symbol to look up and no relocation that could
//! be out of range; its pages are never writable and executable at once, and live as long as the evaluator.
//! The host is examined here: cranelift's own set-up would panic where it is not supported.

use std::sync::{Arc, Mutex, PoisonError};

use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::{AbiParam, BlockArg, InstBuilder, MemFlagsData, SigRef, Signature, Type, Value, types};
use cranelift_codegen::isa::{CallConv, OwnedTargetIsa};
use cranelift_codegen::settings::{self, Configurable};
use cranelift_codegen::{CodegenError, Context};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Module, ModuleError, default_libcall_names};

use crate::expr::{Function, SplineCall, Variable};
use crate::kernels::Rows;

use super::program::{Op, OpId, Program};
use super::{EvalError, Evaluator, Samples, Workspace, checked_points, checked_samples};

#[path = "jit_shims.rs"]
mod shims;

use shims::Shim;

/// Programs with more ops are interpreted.
///
/// Register allocation takes quadratic time when most values are live at once: 0.1 s at this size, 2 s at four
/// times it. The interpreter loses nothing there, since its cost of choosing an op is shared by a block anyway.
/// A value that is spilled takes 8 bytes, so this also bounds the frame, to 32 KiB of the caller's stack.
const LARGEST_PROGRAM: usize = 4096;

/// Bytes from one double to the next.
const STRIDE: i64 = 8;

/// Samples, u, v, t, parameters, values, and the samples from one row of values to the next.
type Entry = unsafe extern "C" fn(usize, *const f64, *const f64, *const f64, *const f64, *mut f64, usize);

/// The evaluator that runs machine code.
pub(super) struct Jit {
    program: Arc<Program>,
    entry: Entry,
    /// Holds the pages that `entry` points into; freed with the evaluator.
    _code: Code,
}

/// The owner of executable pages.
///
/// The mutex is never contended: it makes a module, which is `Send` only, shareable between threads.
struct Code(Mutex<Option<JITModule>>);

impl Drop for Code {
    fn drop(&mut self) {
        let module = self.0.get_mut().unwrap_or_else(PoisonError::into_inner).take();
        if let Some(module) = module {
            // SAFETY: code of this module is entered only by `Jit::evaluate`, through the `entry` stored beside
            // this owner. Being dropped means that no `&Jit` exists, so no call is running or can begin.
            unsafe { module.free_memory() };
        }
    }
}

impl Jit {
    /// Compiles `program`, or says in one line why this host or program has to be interpreted.
    pub(super) fn new(program: Arc<Program>) -> Result<Self, String> {
        if program.ops().len() > LARGEST_PROGRAM {
            return Err(format!(
                "the program has {} operations, machine code is made for up to {LARGEST_PROGRAM}",
                program.ops().len()
            ));
        }
        let builder = JITBuilder::with_isa(host_isa()?, default_libcall_names());
        let mut code = Code(Mutex::new(Some(JITModule::new(builder))));
        let module = code.0.get_mut().unwrap_or_else(PoisonError::into_inner);
        let module = module.as_mut().expect("the module was put there above");
        let id = define(module, &program).map_err(|error| reason(&error))?;
        module.finalize_definitions().map_err(|error| reason(&error))?;
        let address = module.get_finalized_function(id);
        // SAFETY: `address` is the start of the function that `define` built with exactly the signature of `Entry`
        // in the host's C calling convention; it was finalized above, and `code` keeps it mapped.
        let entry = unsafe { std::mem::transmute::<*const u8, Entry>(address) };
        Ok(Jit { program, entry, _code: code })
    }
}

impl Evaluator for Jit {
    fn program(&self) -> &Program {
        &self.program
    }

    fn evaluate(&self, params: &[f64], samples: Samples<'_>, values: &mut [f64]) -> Result<(), EvalError> {
        let points = checked_points(&self.program, params, samples, values)?;
        self.run(params, samples, (values, points));
        Ok(())
    }

    fn evaluate_rows(
        &self,
        params: &[f64],
        samples: Samples<'_>,
        target: &mut Rows,
        _workspace: &mut Workspace,
    ) -> Result<(), EvalError> {
        let points = checked_samples(&self.program, params, samples)?;
        target.reshape(self.program.outputs(), points);
        self.run(params, samples, target.strided());
        Ok(())
    }
}

impl Jit {
    /// Runs the code, once samples and parameters are known to fit the program; rows of values begin `stride` apart.
    fn run(&self, params: &[f64], Samples { u, v, t }: Samples<'_>, (values, stride): (&mut [f64], usize)) {
        let points = u.len();
        let rows = self.program.outputs();
        let needed = rows.saturating_sub(1).saturating_mul(stride).saturating_add(points);
        assert!(rows == 0 || needed <= values.len(), "whoever calls has counted the rows");
        // SAFETY: the callers established that u, v and t hold `points` doubles and `params` every index the
        // program reads, and `values` holds a row of `points` for each output, `stride` apart, as asserted above; the
        // code accesses no others (see `Emitter`), needs no alignment beyond a double's, and `&self` keeps its pages
        // mapped. The splines whose addresses stand in the code belong to `self.program`, which nothing changes or
        // drops meanwhile. `values` is borrowed exclusively, so no slice read here is written by anyone.
        unsafe {
            (self.entry)(points, u.as_ptr(), v.as_ptr(), t.as_ptr(), params.as_ptr(), values.as_mut_ptr(), stride);
        }
    }
}

/// One line about a failure, without the code that failed.
fn reason(error: &ModuleError) -> String {
    match error {
        ModuleError::Compilation(CodegenError::Verifier(_)) => "the code generator refused the program".to_owned(),
        other => other.to_string().lines().next().unwrap_or_default().to_owned(),
    }
}

fn host_isa() -> Result<OwnedTargetIsa, String> {
    if !cfg!(any(target_arch = "x86_64", target_arch = "aarch64")) {
        return Err(format!("the processor architecture {} is not supported", std::env::consts::ARCH));
    }
    let builder = cranelift_native::builder().map_err(str::to_owned)?;
    let mut flags = settings::builder();
    let verifier = if cfg!(debug_assertions) { "true" } else { "false" };
    for (name, value) in [
        // Shared subexpressions and uniform values are dealt with in the program already.
        ("opt_level", "none"),
        ("enable_verifier", verifier),
        // Touches every page of a large frame in order, so that a full stack meets its guard page.
        ("enable_probestack", "true"),
        ("probestack_strategy", "inline"),
        ("is_pic", "false"),
        ("use_colocated_libcalls", "false"),
    ] {
        flags.set(name, value).map_err(|error| error.to_string())?;
    }
    builder.finish(settings::Flags::new(flags)).map_err(|error| error.to_string())
}

/// Generates the code of `program` into `module`.
fn define(module: &mut JITModule, program: &Program) -> Result<FuncId, ModuleError> {
    let pointer = module.isa().pointer_type();
    let convention = module.isa().default_call_conv();
    let mut context = Context::new();
    context.func.signature = signature(convention, &[pointer; 7], &[]);
    let id = module.declare_anonymous_function(&context.func.signature)?;
    let mut builder_context = FunctionBuilderContext::new();
    let mut builder = FunctionBuilder::new(&mut context.func, &mut builder_context);
    let unary = builder.import_signature(signature(convention, &[types::F64], &[types::F64]));
    let binary = builder.import_signature(signature(convention, &[types::F64; 2], &[types::F64]));
    let splines = builder.import_signature(signature(convention, &[pointer, types::F64, types::F64], &[types::F64]));
    let values = Vec::with_capacity(program.ops().len());
    Emitter { builder: &mut builder, program, pointer, unary, binary, splines, values }.function();
    builder.seal_all_blocks();
    builder.finalize(module.target_config());
    module.define_function(id, &mut context)?;
    debug_assert!(
        context.compiled_code().is_some_and(|code| code.buffer.relocs().is_empty()),
        "nothing is left to be resolved by name"
    );
    Ok(id)
}

fn signature(convention: CallConv, arguments: &[Type], results: &[Type]) -> Signature {
    let mut signature = Signature::new(convention);
    signature.params.extend(arguments.iter().copied().map(AbiParam::new));
    signature.returns.extend(results.iter().copied().map(AbiParam::new));
    signature
}

/// Where the inputs of the ops being emitted are.
struct Inputs {
    parameters: Value,
    u: Value,
    v: Value,
    t: Value,
    /// Bytes from the first sample to the present one.
    offset: Value,
}

/// Writes the function's instructions.
///
/// Every address it forms is one of three: a coordinate's base plus an offset that is a multiple of 8 below 8 times
/// the samples; the parameters' base plus 8 times an index below [`Program::symbols`]; the values' base plus such an
/// offset plus k rows for output k. The loop is not entered for no samples.
struct Emitter<'a, 'b> {
    builder: &'a mut FunctionBuilder<'b>,
    program: &'a Program,
    pointer: Type,
    unary: SigRef,
    binary: SigRef,
    splines: SigRef,
    /// What holds each op emitted so far.
    values: Vec<Value>,
}

impl Emitter<'_, '_> {
    /// The whole function: uniform ops, then for each offset below the end the varying ops and the stores.
    fn function(mut self) {
        let [entry, body, done] = [(); 3].map(|()| self.builder.create_block());
        self.builder.append_block_params_for_function_params(entry);
        self.builder.switch_to_block(entry);
        let &[points, u, v, t, parameters, out, stride] = self.builder.block_params(entry) else {
            unreachable!("the signature has seven parameters")
        };
        let end = self.builder.ins().imul_imm_s(points, STRIDE);
        let row = self.builder.ins().imul_imm_s(stride, STRIDE);
        let start = self.builder.ins().iconst(self.pointer, 0);
        let mut inputs = Inputs { parameters, u, v, t, offset: start };
        for &op in self.program.uniform() {
            self.op(op, &inputs);
        }
        self.builder.ins().brif(end, body, &[BlockArg::Value(start)], done, &[]);

        inputs.offset = self.builder.append_block_param(body, self.pointer);
        self.builder.switch_to_block(body);
        for &op in self.program.varying() {
            self.op(op, &inputs);
        }
        self.stores(out, row, inputs.offset);
        let next = self.builder.ins().iadd_imm_s(inputs.offset, STRIDE);
        let is_before_end = self.builder.ins().icmp(IntCC::UnsignedLessThan, next, end);
        self.builder.ins().brif(is_before_end, body, &[BlockArg::Value(next)], done, &[]);

        self.builder.switch_to_block(done);
        self.builder.ins().return_(&[]);
    }

    /// Stores the outputs of one sample: output k at `out + k * row + offset`.
    fn stores(&mut self, out: Value, row: Value, offset: Value) {
        let nan = self.builder.ins().f64const(f64::NAN);
        let mut address = self.builder.ins().iadd(out, offset);
        for (index, &output) in self.program.output_ops().iter().enumerate() {
            if index > 0 {
                address = self.builder.ins().iadd(address, row);
            }
            let value = self.value(output);
            let is_number = self.builder.ins().fcmp(FloatCC::Ordered, value, value);
            let value = self.builder.ins().select(is_number, value, nan);
            self.builder.ins().store(MemFlagsData::trusted(), value, address, 0);
        }
    }

    fn op(&mut self, op: Op, inputs: &Inputs) {
        let value = match op.map(|id| self.value(id)) {
            Op::Constant(value) => self.builder.ins().f64const(value),
            Op::Parameter(index) => {
                let offset = i64::try_from(index).expect("limits keep parameters far below 2^60") * STRIDE;
                let address = self.builder.ins().iadd_imm_s(inputs.parameters, offset);
                self.load(address)
            }
            Op::Variable(variable) => {
                let base = match variable {
                    Variable::U => inputs.u,
                    Variable::V => inputs.v,
                    Variable::T => inputs.t,
                };
                let address = self.builder.ins().iadd(base, inputs.offset);
                self.load(address)
            }
            Op::Neg(a) => self.builder.ins().fneg(a),
            Op::Add(a, b) => self.builder.ins().fadd(a, b),
            Op::Sub(a, b) => self.builder.ins().fsub(a, b),
            Op::Mul(a, b) => self.builder.ins().fmul(a, b),
            Op::Div(a, b) => self.builder.ins().fdiv(a, b),
            Op::Sqrt(a) => self.builder.ins().sqrt(a),
            Op::Call1(function, a) => self.call(function, &[a]),
            Op::Call2(function, a, b) => self.call(function, &[a, b]),
            Op::Spline1(index, a) => {
                let zero = self.builder.ins().f64const(0.0);
                self.spline(index, [a, zero])
            }
            Op::Spline2(index, a, b) => self.spline(index, [a, b]),
        };
        self.values.push(value);
    }

    fn load(&mut self, address: Value) -> Value {
        self.builder.ins().load(types::F64, MemFlagsData::trusted(), address, 0)
    }

    fn call(&mut self, function: Function, arguments: &[Value]) -> Value {
        let (signature, address) = match shims::shim(function) {
            Shim::Unary(shim) => (self.unary, shim as usize),
            Shim::Binary(shim) => (self.binary, shim as usize),
        };
        let address = self.builder.ins().iconst(self.pointer, address.cast_signed() as i64);
        let call = self.builder.ins().call_indirect(signature, address, arguments);
        *self.builder.inst_results(call).first().expect("a function of the table returns one value")
    }

    /// Calls a spline of the program, whose data the evaluator keeps where they are.
    fn spline(&mut self, index: usize, [a, b]: [Value; 2]) -> Value {
        let data: *const SplineCall =
            self.program.splines().get(index).expect("a program has the splines its ops name");
        let data = self.builder.ins().iconst(self.pointer, (data as usize).cast_signed() as i64);
        let address = (shims::spline as extern "C" fn(&SplineCall, f64, f64) -> f64) as usize;
        let address = self.builder.ins().iconst(self.pointer, address.cast_signed() as i64);
        let call = self.builder.ins().call_indirect(self.splines, address, &[data, a, b]);
        *self.builder.inst_results(call).first().expect("a spline returns one value")
    }

    fn value(&self, id: OpId) -> Value {
        *self.values.get(id.index()).expect("operands come before their op")
    }
}
