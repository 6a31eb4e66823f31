//! Random expressions: both evaluators give the same bits, whatever the samples.

use proptest::prelude::*;

use trimline::eval::{Evaluator, Program, Samples};
use trimline::expr::{Constant, ExprId, Function, Graph, Node, Number, Variable};

use super::conformance::{AWKWARD, canonical_bits};
use super::{bits, interpreter, machine_code};

const PARAMETERS: usize = 3;

/// An expression that is not in any graph yet.
#[derive(Debug, Clone)]
enum Tree {
    Variable(Variable),
    Parameter(usize),
    Number(i64, i64),
    Constant(Constant),
    Sum(Vec<Tree>),
    Product(Vec<Tree>),
    Power(Box<Tree>, i64, i64),
    General(Box<Tree>, Box<Tree>),
    Call(Function, Vec<Tree>),
}

impl Tree {
    /// Recursive: the strategy bounds the depth.
    fn build(&self, graph: &mut Graph) -> ExprId {
        match self {
            Tree::Variable(variable) => graph.variable(*variable),
            Tree::Parameter(index) => graph.symbol(["a", "b", "c"][*index]),
            Tree::Number(above, below) => graph.number(Number::fraction(*above, *below).expect("not over zero")),
            Tree::Constant(constant) => graph.constant(*constant),
            Tree::Sum(terms) => {
                let terms = Tree::build_all(terms, graph);
                graph.sum(terms)
            }
            Tree::Product(factors) => {
                let factors = Tree::build_all(factors, graph);
                graph.product(factors)
            }
            Tree::Power(base, above, below) => {
                let base = base.build(graph);
                let exponent = graph.number(Number::fraction(*above, *below).expect("not over zero"));
                graph.power(base, exponent)
            }
            Tree::General(base, exponent) => {
                let (base, exponent) = (base.build(graph), exponent.build(graph));
                graph.power(base, exponent)
            }
            Tree::Call(function, arguments) => {
                let arguments = Tree::build_all(arguments, graph);
                graph.call(*function, &arguments)
            }
        }
    }

    fn build_all(trees: &[Tree], graph: &mut Graph) -> Vec<ExprId> {
        trees.iter().map(|tree| tree.build(graph)).collect()
    }
}

fn tree() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        4 => prop::sample::select(&Variable::ALL[..]).prop_map(Tree::Variable),
        2 => (0..PARAMETERS).prop_map(Tree::Parameter),
        2 => (-9_i64..10, 1_i64..6).prop_map(|(above, below)| Tree::Number(above, below)),
        1 => prop::sample::select(vec![Constant::Pi, Constant::E]).prop_map(Tree::Constant),
    ];
    leaf.prop_recursive(6, 60, 4, |inner| {
        let call = prop::sample::select(Function::ALL)
            .prop_flat_map({
                let inner = inner.clone();
                move |function| (Just(function), prop::collection::vec(inner.clone(), function.arity()))
            })
            .prop_map(|(function, arguments)| Tree::Call(function, arguments));
        prop_oneof![
            3 => prop::collection::vec(inner.clone(), 2..5).prop_map(Tree::Sum),
            3 => prop::collection::vec(inner.clone(), 2..5).prop_map(Tree::Product),
            2 => (inner.clone(), -18_i64..19, 1_i64..4).prop_map(|(base, above, below)| {
                Tree::Power(Box::new(base), above, below)
            }),
            1 => (inner.clone(), inner).prop_map(|(base, exponent)| {
                Tree::General(Box::new(base), Box::new(exponent))
            }),
            4 => call,
        ]
    })
}

/// Mostly numbers of the size that coordinates have; some awkward, some of any bits.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -4.0..4.0,
        1 => prop::sample::select(&AWKWARD[..]),
        1 => any::<u64>().prop_map(f64::from_bits),
    ]
}

fn values_of(evaluator: &dyn Evaluator, params: &[f64], points: &[[f64; 3]]) -> Vec<f64> {
    let [u, v, t] = [0, 1, 2].map(|axis| points.iter().map(|point| point[axis]).collect::<Vec<f64>>());
    let mut values = vec![0.0; evaluator.program().outputs() * points.len()];
    evaluator.evaluate(params, Samples { u: &u, v: &v, t: &t }, &mut values).expect("lengths fit");
    values
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn evaluators_agree_on_random_expressions(
        trees in prop::collection::vec(tree(), 1..4),
        params in prop::array::uniform3(coordinate()),
        points in prop::collection::vec(prop::array::uniform3(coordinate()), 1..40),
    ) {
        let mut graph = Graph::new();
        let symbols = ["a", "b", "c"].map(|name| graph.symbol(name));
        prop_assert_eq!(symbols.len(), PARAMETERS);
        let outputs = Tree::build_all(&trees, &mut graph);
        let program = Program::compile(&graph, &outputs);
        let interpreted = values_of(&*interpreter(program.clone()), &params, &points);
        let compiled = values_of(&*machine_code(program.clone()), &params, &points);
        prop_assert_eq!(bits(&interpreted), bits(&compiled), "{}", program);
    }

    /// Without powers and like terms the program computes what the graph's own walk does, to the last bit.
    #[test]
    fn program_computes_the_value_of_the_graph(
        tree in tree().prop_filter("no powers", |tree| !has_power(tree)),
        params in prop::array::uniform3(coordinate()),
        point in prop::array::uniform3(coordinate()),
    ) {
        let mut graph = Graph::new();
        for name in ["a", "b", "c"] {
            graph.symbol(name);
        }
        let output = tree.build(&mut graph);
        // Merging equal factors makes powers, which programs multiply out.
        let has_powers = graph.reachable(&[output]).iter().any(|&id| {
            matches!(graph.node(id), Node::Power(..))
        });
        prop_assume!(!has_powers && !has_like_terms(&graph, output));
        let program = Program::compile(&graph, &[output]);
        let found = values_of(&*interpreter(program.clone()), &params, &[point]);
        let expected = canonical_bits(graph.value(output, &params, point));
        prop_assert_eq!(bits(&found), vec![expected], "{}", program);
    }
}

/// Whether a sum has terms that differ only in numbers and parameters, which programs collect.
fn has_like_terms(graph: &Graph, output: ExprId) -> bool {
    let varies = |id: &ExprId| {
        let dependence = graph.dependence(*id);
        dependence.u || dependence.v || dependence.t
    };
    let varying = |term: &ExprId| -> Vec<ExprId> {
        let factors = match graph.node(*term) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![*term],
        };
        factors.into_iter().filter(varies).collect()
    };
    graph.reachable(&[output]).iter().any(|&id| {
        let Node::Sum(terms) = graph.node(id) else { return false };
        let all: Vec<Vec<ExprId>> = terms.iter().map(varying).filter(|varying| !varying.is_empty()).collect();
        all.iter().enumerate().any(|(index, one)| all[..index].contains(one))
    })
}

fn has_power(tree: &Tree) -> bool {
    match tree {
        Tree::Variable(_) | Tree::Parameter(_) | Tree::Number(..) | Tree::Constant(_) => false,
        Tree::Sum(trees) | Tree::Product(trees) | Tree::Call(_, trees) => trees.iter().any(has_power),
        Tree::Power(..) | Tree::General(..) => true,
    }
}
