//! The world of a running program: what was declared, written and told so far.

use std::collections::BTreeSet;

use indexmap::IndexSet;
use smallvec::SmallVec;

use crate::trace::{AS_WRITTEN, Arith, Decision, Handle, Num, Op};

use super::error::SceneError;
use super::frame::Frame;
use super::layout::{Warning, WarningKind};
use super::origin::{OriginId, Origins};
use super::settle::{Aim, Question, Settled, decide};
use super::terms::{Anchor, Axis, Cardinal, Given, Kind, ObjectId, Scalar, Support, Target, category_of};
use super::thing::{How, Known, Slot, Thing, Told};

/// How many objects a scene holds at most; more are a `MemoryError`.
pub const MAX_OBJECTS: usize = 200_000;

/// An asset of the floor or the walls.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Surface {
    /// Its name.
    pub asset: String,
    /// RRGGBB.
    pub color: Option<String>,
}

/// The scene itself.
#[derive(Clone, PartialEq, Debug)]
pub struct SceneInfo {
    /// Its title; empty if none was set.
    pub title: String,
    /// Width (x), depth (y), height (z), metres.
    pub dims: [Scalar; 3],
    /// Whether there is a ceiling.
    pub interior: bool,
    /// The floor.
    pub floor: Option<Surface>,
    /// The walls.
    pub wall: Option<Surface>,
}

impl SceneInfo {
    /// Width, depth, height as plain numbers.
    pub fn size(&self) -> [f64; 3] {
        self.dims.map(Scalar::value)
    }
}

impl Default for SceneInfo {
    fn default() -> SceneInfo {
        let dims = [6.0, 6.0, 3.0].map(Scalar::float);
        SceneInfo { title: String::new(), dims, interior: true, floor: None, wall: None }
    }
}

/// A declaration.
#[derive(Clone, PartialEq, Debug)]
pub struct NewObject<'a> {
    /// Object, door or window.
    pub kind: Kind,
    /// The name as given; a trailing number is dropped.
    pub name: &'a str,
    /// Width, depth, height.
    pub dims: [Given; 3],
    /// A support's number; for doors and windows whatever is said is `MOUNTED`.
    pub support: Given,
    /// RRGGBB, with or without `#`; what is neither is ignored with a warning.
    pub color: Option<&'a str>,
    /// Whether physics may move it.
    pub dynamic: bool,
}

/// What a program assigned to a facing.
#[derive(Clone, PartialEq, Debug)]
pub enum FacingSpec {
    /// `None`: nothing happens.
    Nothing,
    /// A direction, in turns or degrees.
    Number(Scalar),
    /// An object or the scene.
    Toward(Target),
    /// The center of an object or of the scene, as it stood in the program: a point, unless it is the object's own.
    CenterOf(Target),
    /// x and y of a point in the current frame.
    Point([Num; 2]),
}

/// A number which literals reach became a direction.
#[derive(Debug)]
struct IsDirection(Num);

impl Decision for IsDirection {
    fn holds(&self, now: &dyn Fn(Num) -> f64) -> bool {
        Cardinal::from_number(now(self.0)).is_some()
    }
}

/// The state of a scene program's scene. See the [room](super).
#[derive(Debug)]
pub struct World {
    pub(super) scene: SceneInfo,
    pub(super) things: Vec<Thing>,
    pub(super) categories: IndexSet<String>,
    /// Per category, the objects that are settled.
    settled: Vec<BTreeSet<u32>>,
    frame: Frame,
    /// Calls and statements that did something; filled by whoever runs the program.
    pub origins: Origins,
    pub(super) warnings: Vec<Warning>,
    writes: u32,
}

impl Default for World {
    fn default() -> World {
        World {
            scene: SceneInfo::default(),
            things: Vec::new(),
            categories: IndexSet::default(),
            settled: Vec::new(),
            frame: Frame::WORLD,
            origins: Origins::default(),
            warnings: Vec::new(),
            writes: 0,
        }
    }
}

/// Checks a size and sets it in stone.
fn size<R: Arith + ?Sized>(rec: &mut R, name: &str, label: &str, given: &Given) -> Result<Scalar, SceneError> {
    match given {
        Given::Number(scalar) if scalar.value().is_finite() && scalar.value() > 0.0 => {
            rec.set_in_stone(scalar.num);
            Ok(Scalar { num: Num::plain(scalar.value()), int: scalar.int })
        }
        _ => Err(SceneError::no_size(name, label, given)),
    }
}

fn sizes<R: Arith + ?Sized>(rec: &mut R, name: &str, dims: &[Given; 3]) -> Result<[Scalar; 3], SceneError> {
    let [width, depth, height] = dims;
    Ok([size(rec, name, "width", width)?, size(rec, name, "depth", depth)?, size(rec, name, "height", height)?])
}

/// RRGGBB without `#`, if that is what the text says.
pub(super) fn color_of(text: &str) -> Option<&str> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    (digits.len() == 6 && digits.bytes().all(|byte| byte.is_ascii_hexdigit())).then_some(digits)
}

impl World {
    /// An empty scene of 6 × 6 × 3.
    pub fn new() -> World {
        World::default()
    }

    /// `set_title`
    pub fn set_title(&mut self, title: &str) {
        self.scene.title = title.to_owned();
    }

    /// `set_size`
    pub fn set_size<R: Arith + ?Sized>(&mut self, rec: &mut R, dims: &[Given; 3]) -> Result<(), SceneError> {
        self.scene.dims = sizes(rec, "set_size", dims)?;
        Ok(())
    }

    /// `set_floor_asset`
    pub fn set_floor_asset(&mut self, asset: &str, color: Option<&str>, origin: OriginId) {
        let color = self.color(color, None, origin);
        self.scene.floor = Some(Surface { asset: asset.to_owned(), color });
    }

    /// `set_wall_asset`
    pub fn set_wall_asset(&mut self, asset: &str, interior: bool, color: Option<&str>, origin: OriginId) {
        let color = self.color(color, None, origin);
        self.scene.wall = Some(Surface { asset: asset.to_owned(), color });
        self.scene.interior = interior;
    }

    /// Whether there is a ceiling.
    pub fn set_interior(&mut self, interior: bool) {
        self.scene.interior = interior;
    }

    fn color(&mut self, text: Option<&str>, object: Option<ObjectId>, origin: OriginId) -> Option<String> {
        let text = text?;
        let color = color_of(text);
        if color.is_none() {
            self.warn(WarningKind::Color { text: text.chars().take(40).collect() }, object, origin);
        }
        color.map(str::to_owned)
    }

    /// One warning a statement and kind is enough.
    fn warn(&mut self, kind: WarningKind, object: Option<ObjectId>, origin: OriginId) {
        let same = |warning: &Warning| std::mem::discriminant(&warning.kind) == std::mem::discriminant(&kind) && warning.origin == origin;
        if !self.warnings.last().is_some_and(same) && self.warnings.len() < 10_000 {
            self.warnings.push(Warning { kind, object, origin });
        }
    }

    /// `Object`, `Door`, `Window`
    pub fn add_object<R: Arith + ?Sized>(&mut self, rec: &mut R, new: &NewObject, origin: OriginId) -> Result<ObjectId, SceneError> {
        let support = match (&new.support, new.kind) {
            (_, Kind::Door | Kind::Window) => Some(Support::Mounted),
            (Given::Number(number), Kind::Object) => Support::from_number(number.value()),
            (Given::Other { repr, .. }, Kind::Object) => match repr.as_str() {
                "False" => Some(Support::Standing),
                "True" => Some(Support::Mounted),
                _ => None,
            },
        };
        let support = support.ok_or_else(|| {
            SceneError::value(format!("{}: support must be STANDING, MOUNTED or FLOATING, not {}", new.name, new.support.shown()))
        })?;
        let name = category_of(new.name);
        let dims = sizes(rec, name, &new.dims)?;
        if self.things.len() >= MAX_OBJECTS {
            return Err(SceneError::too_many(MAX_OBJECTS));
        }
        let category = match self.categories.get_index_of(name) {
            Some(category) => category,
            None => self.categories.insert_full(name.to_owned()).0,
        };
        self.settled.resize_with(self.categories.len(), BTreeSet::new);
        let id = ObjectId(self.things.len() as u32);
        let color = self.color(new.color, Some(id), origin);
        self.things.push(Thing {
            category,
            kind: new.kind,
            support,
            dims,
            color,
            dynamic: new.dynamic && new.kind == Kind::Object,
            declared: origin,
            slots: [None; 3],
            order: SmallVec::new(),
            told: None,
            outcome: None,
        });
        Ok(id)
    }

    /// How many objects there are.
    pub fn len(&self) -> usize {
        self.things.len()
    }

    /// True where nothing was declared.
    pub fn is_empty(&self) -> bool {
        self.things.is_empty()
    }

    /// The category of an object, or `scene`.
    pub fn name(&self, target: Target) -> &str {
        match target {
            Target::Scene => "scene",
            Target::Object(id) => &self.categories[self.things[id.index()].category],
        }
    }

    /// Width, depth, height.
    pub fn dims(&self, target: Target) -> [Scalar; 3] {
        match target {
            Target::Scene => self.scene.dims,
            Target::Object(id) => self.things[id.index()].dims,
        }
    }

    /// Object, door or window.
    pub fn kind(&self, id: ObjectId) -> Kind {
        self.things[id.index()].kind
    }

    /// What holds it up; the scene stands.
    pub fn support(&self, target: Target) -> Support {
        match target {
            Target::Scene => Support::Standing,
            Target::Object(id) => self.things[id.index()].support,
        }
    }

    /// A coordinate in the current frame. Settles an object.
    pub fn read<R: Arith + ?Sized>(&mut self, rec: &mut R, target: Target, anchor: Anchor, axis: Axis) -> Scalar {
        let (part, along) = self.frame.anchor_in_world(anchor, axis);
        let world = match target {
            Target::Scene => self.scene_part(part, along),
            Target::Object(id) => {
                let turn = self.settle(rec, id).turn;
                self.things[id.index()].part(rec, part, along, turn)
            }
        };
        if axis == Axis::Z { world } else { self.frame.local(rec, axis, world.num).into() }
    }

    fn scene_part(&self, part: Anchor, axis: Axis) -> Scalar {
        let dim = self.scene.dims[axis.index()];
        match (axis, part) {
            (Axis::Z, Anchor::Min) | (Axis::X | Axis::Y, Anchor::Center) => Scalar::float(0.0),
            (Axis::Z, Anchor::Max) => dim,
            (Axis::Z, Anchor::Center) | (_, Anchor::Max) => Scalar::float(0.5 * dim.value()),
            (_, Anchor::Min) => Scalar::float(-0.5 * dim.value()),
        }
    }

    /// Writes an anchor in the current frame.
    pub fn write<R: Arith + ?Sized>(
        &mut self,
        rec: &mut R,
        target: Target,
        anchor: Anchor,
        axis: Axis,
        value: &Given,
        origin: OriginId,
    ) -> Result<(), SceneError> {
        let Target::Object(id) = target else { return Err(SceneError::attribute("the scene cannot be moved")) };
        let value = match value {
            Given::Number(scalar) => *scalar,
            Given::Other { type_name, .. } => return Err(SceneError::no_number(self.name(target), anchor, axis, type_name)),
        };
        let (part, along) = self.frame.anchor_in_world(anchor, axis);
        let num = self.frame.world(rec, axis, value.num, value.int);
        let through_frame = (num.handle != value.num.handle).then_some(num);
        for num in [value.num].into_iter().chain(through_frame) {
            if !rec.finite(num) {
                let shown = Scalar::from(num).shown();
                return Err(SceneError::not_finite(self.name(target), anchor, axis, &shown));
            }
        }
        self.writes += 1;
        let slot = Slot { anchor: part, value: Scalar { num, int: value.int && axis == Axis::Z }, origin, when: self.writes };
        let thing = &mut self.things[id.index()];
        if thing.slots[along.index()].replace(slot).is_none() {
            thing.order.push(along);
        }
        Ok(())
    }

    /// Tells an object what to face. `site` is the direction of the program that may stand in its place.
    pub fn set_facing<R: Arith + ?Sized>(
        &mut self,
        rec: &mut R,
        id: ObjectId,
        spec: &FacingSpec,
        site: Handle,
        origin: OriginId,
    ) -> Result<(), SceneError> {
        let instead = Num { value: AS_WRITTEN, handle: site };
        let how = match *spec {
            FacingSpec::Nothing => return Ok(()),
            FacingSpec::Toward(target) | FacingSpec::CenterOf(target) if target == Target::Object(id) => {
                rec.pin(instead);
                self.warn(WarningKind::SelfFacing, Some(id), origin);
                return Ok(());
            }
            FacingSpec::Toward(target) => How::Toward(target),
            FacingSpec::Number(number) => How::Direction(direction(rec, number.num)?),
            FacingSpec::CenterOf(target) => {
                self.pin_if_unsettled(rec, target, instead);
                let [x, y] = [Axis::X, Axis::Y].map(|axis| self.read(rec, target, Anchor::Center, axis).num);
                How::Point(self.frame.point(rec, x, y))
            }
            FacingSpec::Point([x, y]) => {
                let point = self.frame.point(rec, x, y);
                if !point.iter().all(|coordinate| rec.finite(*coordinate)) {
                    let name = self.name(Target::Object(id));
                    return Err(SceneError::value(format!("{name}.facing takes a point with finite coordinates")));
                }
                How::Point(point)
            }
        };
        self.writes += 1;
        let thing = &mut self.things[id.index()];
        thing.told = Some(Told { how, instead, origin, when: self.writes });
        thing.outcome = None;
        self.settled[thing.category].remove(&id.0);
        Ok(())
    }

    /// What is asked of another object settles it; a direction in its place would not ask.
    fn pin_if_unsettled<R: Arith + ?Sized>(&self, rec: &mut R, target: Target, instead: Num) {
        if matches!(target, Target::Object(id) if self.things[id.index()].outcome.is_none()) {
            rec.pin(instead);
        }
    }

    /// The number of the direction that an object faces, settled now; the scene faces `YMax`.
    pub fn facing<R: Arith + ?Sized>(&mut self, rec: &mut R, target: Target) -> Scalar {
        match target {
            Target::Scene => Scalar::int(Cardinal::YMax as i64),
            Target::Object(id) => Scalar { num: self.settle(rec, id).turn, int: true },
        }
    }

    /// `set_coordinate_frame`
    pub fn set_frame<R: Arith + ?Sized>(&mut self, rec: &mut R, target: Target) {
        self.frame = match target {
            Target::Scene => Frame::WORLD,
            Target::Object(id) => {
                let turn = self.settle(rec, id).turn;
                rec.pin(turn);
                let thing = &self.things[id.index()];
                Frame { origin: [Axis::X, Axis::Y].map(|axis| thing.center(rec, axis, turn).num), turn: Cardinal::of_turn(turn) }
            }
        };
    }

    /// The current frame.
    pub fn frame(&self) -> Frame {
        self.frame
    }

    /// Puts a frame back, as after a statement that failed.
    pub fn restore_frame(&mut self, frame: Frame) {
        self.frame = frame;
    }

    /// Settles an object, and before it those that it faces. In a cycle the last one asked counts as turned to `YMax`.
    pub(super) fn settle<R: Arith + ?Sized>(&mut self, rec: &mut R, id: ObjectId) -> Known {
        if let Some(known) = self.things[id.index()].outcome {
            return known;
        }
        let mut chain: IndexSet<ObjectId, rustc_hash::FxBuildHasher> = IndexSet::default();
        let mut next = Some(id);
        while let Some(id) = next {
            chain.insert(id);
            let told = self.things[id.index()].told;
            next = match told.map(|told| told.how) {
                Some(How::Toward(Target::Object(target))) => Some(target),
                _ => None,
            };
            if let Some((target, told)) = next.zip(told) {
                self.pin_if_unsettled(rec, Target::Object(target), told.instead);
            }
            next = next.filter(|target| self.things[target.index()].outcome.is_none() && !chain.contains(target));
        }
        let mut last = self.decide(rec, chain.pop().unwrap_or(id));
        while let Some(id) = chain.pop() {
            last = self.decide(rec, id);
        }
        last
    }

    fn decide<R: Arith + ?Sized>(&mut self, rec: &mut R, id: ObjectId) -> Known {
        let question = self.question(id);
        let outcome = decide(&question.map(|num| num.value));
        let mut inputs: SmallVec<[Num; 8]> = SmallVec::new();
        question.map(|num| inputs.push(num));
        let code = rec.derived(&inputs, outcome.code(), &mut || Box::new(Settled(question)));
        let turn = rec.compute(Op::Fmod, code, Num::plain(4.0));
        let known = Known { outcome, code, turn };
        let thing = &mut self.things[id.index()];
        thing.outcome = Some(known);
        self.settled[thing.category].insert(id.0);
        known
    }

    fn question(&self, id: ObjectId) -> Question<Num> {
        let thing = &self.things[id.index()];
        let aim = match thing.told.map(|told| told.how) {
            Some(How::Direction(turn)) => Aim::Direction(turn),
            Some(How::Point(point)) => Aim::Point(point),
            Some(How::Toward(Target::Scene)) => Aim::Scene,
            Some(How::Toward(Target::Object(target))) => {
                let target = &self.things[target.index()];
                let turn = target.outcome.map_or(Num::plain(f64::from(Cardinal::YMax as u8)), |known| known.turn);
                Aim::Object { dims: target.size(), anchors: target.anchors(), turn }
            }
            None => {
                let first = self.settled[thing.category].first();
                Aim::Free { precedent: first.and_then(|id| self.things[*id as usize].outcome).map(|known| known.code) }
            }
        };
        let instead = thing.told.map_or(Num::plain(AS_WRITTEN), |told| told.instead);
        Question { dims: thing.size(), anchors: thing.anchors(), scene: self.scene.size(), aim, instead }
    }
}

/// A number as a facing; for NaN and infinity what Python says of their truncation.
fn direction<R: Arith + ?Sized>(rec: &mut R, number: Num) -> Result<Num, SceneError> {
    Cardinal::from_number(number.value).ok_or_else(|| {
        if number.value.is_nan() {
            SceneError::value("cannot convert float NaN to integer")
        } else {
            SceneError { exception: "OverflowError", message: "cannot convert float infinity to integer".into() }
        }
    })?;
    rec.decided(&[number], &mut || Box::new(IsDirection(number)));
    Ok(number)
}
