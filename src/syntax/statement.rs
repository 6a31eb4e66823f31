//! Parsed lines to statements of the [`Document`].

use super::assembly::{self, EdgeStatement};
use super::ast::{
    Boundary, Constraint, Constraints, Copies, Definition, DefinitionKind, Deformation, Document, Expression, Join,
    Kind, Knots, Layer, Morph, Name, NetBlock, NetStatement, Parameter, PatchBlock, PdeStatement, Range, Seam,
    SeamEdge, Setting, SolveStatement, Statements, Unknown,
};
use super::expression::Builder;
use super::parser::{Parsed, Rule};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Derivative, canonical_name};

/// A statement and what it adds to a document.
pub enum Statement {
    /// `param …`
    Parameters(Vec<Parameter>),
    /// `let …`
    Definitions(Vec<Definition>),
    /// `domain …`
    Ranges(Vec<Range>),
    /// `pde …`
    Equation(PdeStatement),
    /// `at u = c: …`
    Boundary(Boundary),
    /// Constraints of the boundary block that is open.
    Constraints(Constraints),
    /// `deform …`
    Deformation(Deformation),
    /// `solve …`
    Solve(SolveStatement),
    /// `seam …`
    Seam(Seam),
    /// `morph …`
    Morph(Morph),
    /// `patch NAME {`
    PatchBegins(Name),
    /// `bspline NAME {`
    NetBegins(Name),
    /// `knots …`
    Knots(Vec<Knots>),
    /// `net …`
    Net(NetStatement),
    /// `layer …`
    Layer(Layer),
    /// `nsided NAME {`
    LoopBegins(Name),
    /// `edge …`
    Edge(EdgeStatement),
    /// `centre = …`
    Centre(Expression, Span),
    /// `mirror …` or `repeat …`
    Copies(Copies),
    /// `}`
    BlockEnds,
}

/// The kind of block that is open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Block {
    /// `patch NAME {` or `nsided NAME {`
    Patch,
    /// `bspline NAME {`
    Net,
}

impl Statement {
    /// Adds the statement to `document`: to its last patch or net while a block is `open`. After a fault, `is_faulty`,
    /// what stands outside the boundary or block it needs goes nowhere: that may begin in what could not be read.
    pub fn add_to(self, document: &mut Document, open: &mut Option<Block>, is_faulty: bool) -> Result<(), Diagnostic> {
        match (document.nets.last_mut(), *open) {
            (Some(block), Some(Block::Net)) if self.is_of_nets() => {
                self.add_to_net(block)?;
                document.note_files();
                return Ok(());
            }
            (_, Some(Block::Net)) if !matches!(self, Statement::BlockEnds) => return Err(self.outside_nets()),
            _ => {}
        }
        let section = match document.patches.last_mut() {
            Some(block) if *open == Some(Block::Patch) => &mut block.statements,
            _ => &mut document.shared,
        };
        let is_open = open.is_some();
        match self {
            Statement::Parameters(parameters) => {
                if let (true, Some(first)) = (is_open, parameters.first()) {
                    return Err(shared_only("param", &first.name));
                }
                document.parameters.extend(parameters);
            }
            Statement::Definitions(definitions) => {
                let surface = definitions.iter().find(|definition| definition.kind != DefinitionKind::Let);
                if let (true, Some(surface)) = (is_open, surface) {
                    let what = if surface.kind == DefinitionKind::Curve { "curve" } else { "surface" };
                    return Err(shared_only(what, &surface.name));
                }
                section.definitions.extend(definitions);
                document.note_files();
            }
            Statement::Ranges(ranges) => section.ranges.extend(ranges),
            Statement::Equation(equation) => section.equations.push(equation),
            Statement::Boundary(boundary) => section.boundaries.push(boundary),
            Statement::Deformation(deformation) => section.deformations.push(deformation),
            Statement::Solve(solve) => section.solves.push(solve),
            Statement::Constraints(constraints) => match section.boundaries.last_mut() {
                Some(boundary) => {
                    boundary.constraints.single.extend(constraints.single);
                    boundary.constraints.joins.extend(constraints.joins);
                    boundary.constraints.apexes.extend(constraints.apexes);
                }
                None if is_faulty => {}
                None => {
                    let first = constraints.single.first().map(|constraint| constraint.span);
                    let first = first
                        .or(constraints.joins.first().map(|join| join.span))
                        .or(constraints.apexes.first().copied());
                    return Err(Diagnostic::new(Code::UnexpectedText, "a constraint stands outside a boundary block")
                        .at(first)
                        .hint("open the block first: `at u = 0:`"));
                }
            },
            Statement::Seam(seam) => {
                if is_open {
                    return Err(shared_only("seam", &seam.edges[0].patch));
                }
                document.seams.push(seam);
            }
            Statement::Morph(morph) => {
                if let (true, Some([first, _])) = (is_open, morph.pairs.first()) {
                    return Err(shared_only("morph", first));
                }
                document.morphs.push(morph);
            }
            Statement::PatchBegins(name) => {
                document.patches.push(PatchBlock { name, is_loop: false, statements: Statements::default() });
                *open = Some(Block::Patch);
            }
            Statement::NetBegins(name) => {
                document.nets.push(NetBlock::new(name));
                *open = Some(Block::Net);
            }
            Statement::LoopBegins(name) => {
                document.patches.push(PatchBlock { name, is_loop: true, statements: Statements::default() });
                *open = Some(Block::Patch);
            }
            Statement::Edge(edge) => edge.add_to(document, *open)?,
            Statement::Centre(centre, span) => assembly::add_centre(document, *open, centre, span)?,
            Statement::Copies(copies) => {
                if let (Some(_), Some(first)) = (*open, copies.patches.first()) {
                    return Err(shared_only("copy", first));
                }
                document.copies.push(copies);
            }
            Statement::BlockEnds => *open = None,
            Statement::Knots(_) | Statement::Net(_) | Statement::Layer(_) if is_faulty => {}
            Statement::Knots(_) | Statement::Net(_) | Statement::Layer(_) => return Err(self.only_in_nets()),
        }
        Ok(())
    }
}

fn shared_only(what: &str, name: &Name) -> Diagnostic {
    Diagnostic::new(Code::UnexpectedText, format!("a {what} belongs to all patches, so it cannot stand inside one"))
        .at(name.span)
        .hint("declare it before the patches; what differs between patches can be a `let`")
}

impl Builder<'_> {
    /// Builds the statement of a `line` pair.
    pub fn statement(&mut self, line: Parsed<'_>) -> Result<Statement, Diagnostic> {
        let statement = line.into_inner().next().ok_or_else(internal)?;
        let whole = self.span(&statement);
        let rule = statement.as_rule();
        let parts = statement.into_inner();
        Ok(match rule {
            Rule::param_line => Statement::Parameters(
                parts
                    .filter(|part| part.as_rule() == Rule::parameter)
                    .map(|part| self.parameter(part))
                    .collect::<Result<_, _>>()?,
            ),
            Rule::let_line => Statement::Definitions(
                parts
                    .filter(|part| part.as_rule() == Rule::definition)
                    .map(|part| self.definition(part))
                    .collect::<Result<_, _>>()?,
            ),
            Rule::surface_line => Statement::Definitions(
                parts
                    .filter(|part| matches!(part.as_rule(), Rule::surface | Rule::imported))
                    .map(|part| match part.as_rule() {
                        Rule::imported => self.imported(part),
                        _ => self.definition(part),
                    })
                    .collect::<Result<_, _>>()?,
            ),
            Rule::curve_line => Statement::Definitions(
                parts
                    .filter(|part| part.as_rule() == Rule::curve)
                    .map(|part| self.curve(part))
                    .collect::<Result<_, _>>()?,
            ),
            Rule::domain_line => Statement::Ranges(
                parts
                    .filter(|part| part.as_rule() == Rule::range)
                    .map(|part| self.range(part))
                    .collect::<Result<_, _>>()?,
            ),
            Rule::pde_line => {
                let mut statement = PdeStatement { sides: None, coefficients: Vec::new(), span: whole };
                for part in parts {
                    match part.as_rule() {
                        Rule::equation => {
                            let mut inner = part.into_inner();
                            statement.sides =
                                Some([self.take_expression(&mut inner)?, self.take_expression(&mut inner)?]);
                        }
                        Rule::assignment => {
                            let mut inner = part.into_inner();
                            let name = self.take_name(&mut inner)?;
                            statement.coefficients.push((name, self.take_expression(&mut inner)?));
                        }
                        _ => {}
                    }
                }
                Statement::Equation(statement)
            }
            Rule::at_line => {
                let mut inner = parts.filter(|part| part.as_rule() != Rule::kw_at);
                let variable = self.take_name(&mut inner)?;
                let position = self.take_expression(&mut inner)?;
                let constraints =
                    inner.next().map_or(Ok(Constraints::default()), |list| self.constraints(list.into_inner()))?;
                Statement::Boundary(Boundary { variable, position, constraints })
            }
            Rule::constraints => Statement::Constraints(self.constraints(parts)?),
            Rule::solve_line => Statement::Solve(self.solve(parts)?),
            Rule::deform_line => Statement::Deformation(self.deformation(parts, whole)?),
            Rule::seam_line => {
                let mut edges = parts.filter(|part| part.as_rule() == Rule::seam_edge);
                let edges = [self.seam_edge(edges.next())?, self.seam_edge(edges.next())?];
                Statement::Seam(Seam { edges, span: whole })
            }
            Rule::morph_line => Statement::Morph(self.morph(parts, whole)?),
            Rule::patch_line => Statement::PatchBegins(self.take_name(&mut parts.into_iter())?),
            Rule::bspline_line => Statement::NetBegins(self.take_name(&mut parts.into_iter())?),
            Rule::knots_line => Statement::Knots(self.all_knots(parts)?),
            Rule::net_line => Statement::Net(self.net(parts, whole)?),
            Rule::layer_line => Statement::Layer(self.layer(parts)?),
            Rule::patch_end => Statement::BlockEnds,
            Rule::nsided_line => Statement::LoopBegins(self.take_name(&mut parts.into_iter())?),
            Rule::edge_line => Statement::Edge(self.edge(parts, whole)?),
            Rule::centre_line => {
                let mut inner = parts.filter(|part| part.as_rule() == Rule::expression);
                Statement::Centre(self.take_expression(&mut inner)?, whole)
            }
            Rule::mirror_line => Statement::Copies(self.mirror(parts, whole)?),
            Rule::repeat_line => Statement::Copies(self.repeat(parts, whole)?),
            _ => return Err(internal()),
        })
    }

    fn deformation<'a>(
        &mut self,
        parts: impl Iterator<Item = Parsed<'a>>,
        span: Span,
    ) -> Result<Deformation, Diagnostic> {
        let words = [Rule::kw_deform, Rule::kw_by, Rule::kw_keeping];
        let mut inner = parts.filter(|part| !words.contains(&part.as_rule()));
        let region = [self.range(take(&mut inner, Rule::range)?)?, self.range(take(&mut inner, Rule::range)?)?];
        let by = self.take_expression(&mut inner)?;
        Ok(Deformation { region, by, continuity: self.take_name(&mut inner)?, span })
    }

    fn morph<'a>(&mut self, parts: impl Iterator<Item = Parsed<'a>>, span: Span) -> Result<Morph, Diagnostic> {
        let mut morph = Morph { pairs: Vec::new(), by: None, settings: Vec::new(), span };
        for part in parts {
            match part.as_rule() {
                Rule::pair => {
                    let mut names = part.into_inner();
                    morph.pairs.push([self.take_name(&mut names)?, self.take_name(&mut names)?]);
                }
                Rule::word => morph.by = Some(self.word(&part)),
                Rule::setting => morph.settings.push(self.setting(part)?),
                _ => {}
            }
        }
        Ok(morph)
    }

    fn seam_edge(&mut self, part: Option<Parsed<'_>>) -> Result<SeamEdge, Diagnostic> {
        let mut inner = part.ok_or_else(internal)?.into_inner().filter(|part| part.as_rule() != Rule::kw_at);
        let (patch, variable) = (self.take_name(&mut inner)?, self.take_name(&mut inner)?);
        let position = self.take_expression(&mut inner)?;
        let along = inner.next().map(|range| self.range(range)).transpose()?;
        Ok(SeamEdge { patch, variable, position, along })
    }

    fn parameter(&mut self, part: Parsed<'_>) -> Result<Parameter, Diagnostic> {
        let mut inner = part.into_inner().filter(|part| part.as_rule() != Rule::kw_in);
        let name = self.take_name(&mut inner)?;
        let value = self.take_expression(&mut inner)?;
        let interval = inner.next().map(|interval| self.interval(&interval)).transpose()?;
        Ok(Parameter { name, value, interval })
    }

    fn definition(&mut self, part: Parsed<'_>) -> Result<Definition, Diagnostic> {
        let is_surface = part.as_rule() == Rule::surface;
        let mut inner = part.into_inner().peekable();
        let name = self.take_name(&mut inner)?;
        let formals = match inner.next_if(|part| part.as_rule() == Rule::formals) {
            Some(formals) => {
                let values = self.bracket(&formals)?;
                let formal = |value: &Expression| match &self.tree.node(*value).kind {
                    Kind::Name(name) => Ok(name.clone()),
                    _ => Err(Diagnostic::new(Code::UnexpectedText, "the argument of a definition is a name")
                        .at(self.tree.span(*value))
                        .hint("as in `let f(x, y) = x + y`")),
                };
                values.iter().map(formal).collect::<Result<_, _>>()?
            }
            None => Vec::new(),
        };
        let value = self.take_expression(&mut inner)?;
        let ranges = inner.filter(|part| part.as_rule() == Rule::range).map(|part| self.range(part));
        let ranges = ranges.collect::<Result<_, _>>()?;
        let kind = if is_surface { DefinitionKind::Surface(ranges) } else { DefinitionKind::Let };
        Ok(Definition { kind, name, formals, value })
    }

    fn range(&mut self, part: Parsed<'_>) -> Result<Range, Diagnostic> {
        let mut inner = part.into_inner().filter(|part| part.as_rule() != Rule::kw_in);
        let variable = self.take_name(&mut inner)?;
        let interval = self.interval(&take(&mut inner, Rule::interval)?)?;
        Ok(Range { variable, interval })
    }

    fn interval(&mut self, part: &Parsed<'_>) -> Result<[Expression; 2], Diagnostic> {
        let values = self.bracket(part)?;
        <[Expression; 2]>::try_from(values).map_err(|_| {
            Diagnostic::new(Code::UnexpectedText, "an interval has two ends: `[lo, hi]`").at(self.span(part))
        })
    }

    fn constraints<'a>(&mut self, parts: impl Iterator<Item = Parsed<'a>>) -> Result<Constraints, Diagnostic> {
        let mut constraints = Constraints::default();
        for part in parts.filter(|part| part.as_rule() == Rule::constraint) {
            let span = self.span(&part);
            let mut inner = part.into_inner().peekable();
            if inner.next_if(|part| part.as_rule() == Rule::apex).is_some() {
                constraints.apexes.push(span);
                continue;
            }
            if let Some(join) = inner.next_if(|part| part.as_rule() == Rule::join) {
                constraints.joins.push(self.join(join)?);
                continue;
            }
            let target = self.target(take(&mut inner, Rule::target)?)?;
            constraints.single.push(Constraint { target, value: self.take_expression(&mut inner)?, span });
        }
        Ok(constraints)
    }

    fn join(&mut self, part: Parsed<'_>) -> Result<Join, Diagnostic> {
        let span = self.span(&part);
        let mut inner = part.into_inner().filter(|part| part.as_rule() != Rule::kw_join).peekable();
        let surface = self.take_name(&mut inner)?;
        let at = match inner.next_if(|part| part.as_rule() == Rule::joined_at) {
            None => None,
            Some(at) => {
                let mut inner = at.into_inner().filter(|part| part.as_rule() != Rule::kw_at);
                Some((self.take_name(&mut inner)?, self.take_expression(&mut inner)?))
            }
        };
        let mut join = Join { surface, at, is_reversed: false, strength: None, is_flipped: false, span };
        for option in inner {
            let place = self.span(&option);
            let is_new = match option.as_rule() {
                Rule::flip => !std::mem::replace(&mut join.is_flipped, true),
                Rule::reversed => !std::mem::replace(&mut join.is_reversed, true),
                _ => {
                    let mut inner = option.into_inner().filter(|part| part.as_rule() == Rule::expression);
                    let strength = self.take_expression(&mut inner)?;
                    join.strength.replace(strength).is_none()
                }
            };
            if !is_new {
                let finding = Diagnostic::new(Code::DuplicateStatement, "this is said twice of the same join");
                return Err(finding.at(place));
            }
        }
        Ok(join)
    }

    fn target(&mut self, part: Parsed<'_>) -> Result<Unknown, Diagnostic> {
        let span = self.span(&part);
        let mut inner = part.into_inner();
        let first = inner.next().ok_or_else(internal)?;
        let unknown = match first.as_rule() {
            Rule::derivative => self.derivative(first)?,
            Rule::unknown => self.unknown(&first),
            _ => Unknown { component: coordinate(first.as_str()), derivative: Derivative::NONE, span },
        };
        if let Some(coordinates) = inner.next() {
            self.coordinates(&coordinates)?;
        }
        Ok(Unknown { span, ..unknown })
    }

    fn solve<'a>(&mut self, parts: impl Iterator<Item = Parsed<'a>>) -> Result<SolveStatement, Diagnostic> {
        let mut inner = parts.filter(|part| part.as_rule() != Rule::kw_solve);
        let method = self.word(&take(&mut inner, Rule::word)?);
        let mut settings = Vec::new();
        for part in inner {
            settings.push(self.setting(part)?);
        }
        Ok(SolveStatement { method, settings })
    }

    fn setting(&self, part: Parsed<'_>) -> Result<Setting, Diagnostic> {
        let mut parts = part.into_inner();
        let key = self.word(&take(&mut parts, Rule::word)?);
        let value = take(&mut parts, Rule::setting_value)?;
        let text: String = value.as_str().chars().filter(|c| !c.is_whitespace()).collect();
        Ok(Setting { key, value: text.replace('×', "x"), span: self.span(&value) })
    }

    fn word(&self, part: &Parsed<'_>) -> Name {
        Name { text: part.as_str().trim_end().to_owned(), span: self.span(part) }
    }

    pub fn take_name<'a>(&self, parts: &mut impl Iterator<Item = Parsed<'a>>) -> Result<Name, Diagnostic> {
        let part = parts.find(|part| part.as_rule() == Rule::name).ok_or_else(internal)?;
        Ok(self.name(&part))
    }

    pub fn take_expression<'a>(
        &mut self,
        parts: &mut impl Iterator<Item = Parsed<'a>>,
    ) -> Result<Expression, Diagnostic> {
        self.expression(take(parts, Rule::expression)?)
    }
}

/// 0, 1, 2 for `x` or `x_1`, `y` or `x_2`, `z` or `x_3`.
pub fn coordinate(text: &str) -> Option<usize> {
    match canonical_name(text.trim_end()).as_str() {
        "x" | "x1" => Some(0),
        "y" | "x2" => Some(1),
        "z" | "x3" => Some(2),
        _ => None,
    }
}

pub fn take<'a>(parts: &mut impl Iterator<Item = Parsed<'a>>, rule: Rule) -> Result<Parsed<'a>, Diagnostic> {
    parts.next().filter(|part| part.as_rule() == rule).ok_or_else(internal)
}

/// The grammar guarantees the parts that are taken here.
pub fn internal() -> Diagnostic {
    Diagnostic::new(Code::UnexpectedText, "the grammar and its reader disagree: please report this text")
}
