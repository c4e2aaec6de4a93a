//! glTF 2.0 in one binary file: one node an object.
//!
//! glTF is Y up, and its models look along +Z: (x, y, z) of the scene becomes (x, z, −y), and an object's node is turned about the
//! vertical so that its own +Z is where the object faces. Its scale is then (width, height, depth).

use super::Subject;
use super::colour::Rgb;
use super::pieces::{Piece, Pieces};
use crate::scene::Cardinal;
use gltf_json::accessor::{ComponentType, GenericComponentType, Type};
use gltf_json::buffer::{Target, View};
use gltf_json::material::{PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::scene::UnitQuaternion;
use gltf_json::validation::Checked::Valid;
use gltf_json::{Accessor, Asset, Buffer, Index, Material, Mesh, Node, Root, Scene};
use rustc_hash::FxHashMap;
use serde::Serialize;

/// Half a right angle, as part of a quaternion.
const DIAGONAL: f32 = std::f32::consts::FRAC_1_SQRT_2;

/// The scene's coordinates as glTF's.
fn y_up([x, y, z]: [f64; 3]) -> [f32; 3] {
    // The sum takes the sign off a zero.
    [x, z, -y].map(|value| value as f32 + 0.0)
}

/// What turns +Z to where an object faces.
fn rotation(turn: Cardinal) -> Option<UnitQuaternion> {
    match turn {
        Cardinal::YMin => None,
        Cardinal::XMax => Some(UnitQuaternion([0.0, DIAGONAL, 0.0, DIAGONAL])),
        Cardinal::YMax => Some(UnitQuaternion([0.0, 1.0, 0.0, 0.0])),
        Cardinal::XMin => Some(UnitQuaternion([0.0, -DIAGONAL, 0.0, DIAGONAL])),
    }
}

/// Points and normals of a cube of 1 m around the origin, six faces of four corners.
fn cube() -> (Vec<[f32; 3]>, Vec<[f32; 3]>) {
    let mut points = Vec::with_capacity(24);
    let mut normals = Vec::with_capacity(24);
    for axis in 0..3 {
        for side in [-1.0_f32, 1.0] {
            for [u, v] in [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]] {
                let (mut point, mut normal) = ([0.0; 3], [0.0; 3]);
                point[axis] = 0.5 * side;
                // Counterclockwise as seen from outside on both sides.
                point[(axis + 1) % 3] = u * side;
                point[(axis + 2) % 3] = v;
                normal[axis] = side;
                points.push(point);
                normals.push(normal);
            }
        }
    }
    (points, normals)
}

#[derive(Serialize)]
struct NodeExtras<'a> {
    category: &'a str,
    support: &'a str,
    path: &'a str,
    #[serde(rename = "type")]
    kind: &'a str,
    facing: &'a str,
    dynamic: bool,
    /// The line that declares it, and those that place it.
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    lines: Vec<usize>,
}

#[derive(Serialize)]
struct SceneExtras<'a> {
    /// Width, depth, height in metres.
    size: [Option<f64>; 3],
    interior: bool,
    #[serde(rename = "leftOut", skip_serializing_if = "Vec::is_empty")]
    left_out: Vec<&'a str>,
}

fn extras(value: &impl Serialize) -> gltf_json::Extras {
    serde_json::value::to_raw_value(value).ok()
}

#[derive(Default)]
struct Writer {
    root: Root,
    bytes: Vec<u8>,
    materials: FxHashMap<Rgb, Index<Material>>,
    meshes: FxHashMap<Rgb, Index<Mesh>>,
    cube: Option<Shape>,
}

/// The accessors of points, normals and corners.
#[derive(Clone, Copy)]
struct Shape([Index<Accessor>; 3]);

pub(super) fn glb(subject: &Subject, pieces: &Pieces) -> Vec<u8> {
    let mut writer = Writer::default();
    let mut nodes = Vec::with_capacity(pieces.shown.len() + pieces.surfaces.len());
    for piece in &pieces.shown {
        nodes.push(writer.object(subject, piece));
    }
    for surface in &pieces.surfaces {
        let shape = writer.shape(&surface.corners.map(y_up), &[y_up(surface.normal); 4]);
        let mesh = writer.mesh(shape, surface.colour);
        nodes.push(writer.root.push(node(surface.name, Some(mesh))));
    }
    if nodes.is_empty() {
        // glTF knows no empty list of nodes.
        nodes.push(writer.root.push(node("empty", None)));
    }
    let scene = &subject.layout.scene;
    let left_out = pieces.hidden.iter().map(|(object, _)| object.path.as_str()).collect();
    let size = scene.size().map(|length| length.is_finite().then_some(length));
    let about = SceneExtras { size, interior: scene.interior, left_out };
    let name = (!scene.title.is_empty()).then(|| scene.title.clone());
    let scene = writer.root.push(Scene { extensions: None, extras: extras(&about), name, nodes });
    writer.root.scene = Some(scene);
    writer.root.asset = Asset { generator: Some("psdl".into()), ..Asset::default() };
    writer.finish()
}

fn node(name: &str, mesh: Option<Index<Mesh>>) -> Node {
    Node { name: Some(name.to_owned()), mesh, ..Node::default() }
}

impl Writer {
    fn object(&mut self, subject: &Subject, piece: &Piece) -> Index<Node> {
        let (object, body) = (piece.object, &piece.object.body);
        let mesh = match self.meshes.get(&piece.colour) {
            Some(mesh) => *mesh,
            None => {
                let shape = self.cube();
                let mesh = self.mesh(shape, piece.colour);
                self.meshes.insert(piece.colour, mesh);
                mesh
            }
        };
        let about = NodeExtras {
            category: &object.name,
            support: body.support.name(),
            path: &object.path,
            kind: body.kind.name(),
            facing: body.turn.name(),
            dynamic: object.dynamic,
            line: subject.line_of_object(object),
            lines: subject.layout.placing_lines(object, subject.line_of),
        };
        let [width, depth, height] = body.dims;
        self.root.push(Node {
            translation: Some(y_up(body.center)),
            rotation: rotation(body.turn),
            scale: Some([width, height, depth].map(|extent| extent as f32)),
            extras: extras(&about),
            ..node(&object.path, Some(mesh))
        })
    }

    fn cube(&mut self) -> Shape {
        if let Some(shape) = self.cube {
            return shape;
        }
        let (points, normals) = cube();
        let shape = self.shape(&points, &normals);
        *self.cube.insert(shape)
    }

    /// Faces of four corners each.
    fn shape(&mut self, points: &[[f32; 3]], normals: &[[f32; 3]]) -> Shape {
        let bounds = |pick: fn(f32, f32) -> f32| points.iter().copied().reduce(|a, b| [0, 1, 2].map(|k| pick(a[k], b[k])));
        let (min, max) = (bounds(f32::min), bounds(f32::max));
        let flat = |points: &[[f32; 3]]| points.iter().flatten().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>();
        let corners = (0..points.len() as u16 / 4).flat_map(|face| [0, 1, 2, 0, 2, 3].map(|corner| 4 * face + corner));
        let corners: Vec<u16> = corners.collect();
        let corner_bytes: Vec<u8> = corners.iter().flat_map(|corner| corner.to_le_bytes()).collect();
        let (of_points, of_corners) = ((ComponentType::F32, Type::Vec3), (ComponentType::U16, Type::Scalar));
        let position = self.accessor(&flat(points), points.len(), of_points, Target::ArrayBuffer);
        self.root.accessors[position.value()].min = min.map(|min| serde_json::json!(min));
        self.root.accessors[position.value()].max = max.map(|max| serde_json::json!(max));
        let normal = self.accessor(&flat(normals), normals.len(), of_points, Target::ArrayBuffer);
        let indices = self.accessor(&corner_bytes, corners.len(), of_corners, Target::ElementArrayBuffer);
        Shape([position, normal, indices])
    }

    fn accessor(&mut self, bytes: &[u8], count: usize, (component, kind): (ComponentType, Type), target: Target) -> Index<Accessor> {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let view = self.root.push(View {
            buffer: Index::new(0),
            byte_length: bytes.len().into(),
            byte_offset: Some(self.bytes.len().into()),
            byte_stride: None,
            name: None,
            target: Some(Valid(target)),
            extensions: None,
            extras: None,
        });
        self.bytes.extend_from_slice(bytes);
        self.root.push(Accessor {
            buffer_view: Some(view),
            byte_offset: None,
            count: count.into(),
            component_type: Valid(GenericComponentType(component)),
            extensions: None,
            extras: None,
            type_: Valid(kind),
            min: None,
            max: None,
            name: None,
            normalized: false,
            sparse: None,
        })
    }

    fn mesh(&mut self, Shape([position, normal, indices]): Shape, colour: Rgb) -> Index<Mesh> {
        let material = self.material(colour);
        let attributes = [(Valid(Semantic::Positions), position), (Valid(Semantic::Normals), normal)].into();
        let primitive = Primitive {
            attributes,
            indices: Some(indices),
            material: Some(material),
            mode: Valid(Mode::Triangles),
            targets: None,
            extensions: None,
            extras: None,
        };
        self.root.push(Mesh { primitives: vec![primitive], name: Some(colour.hex()), weights: None, extensions: None, extras: None })
    }

    fn material(&mut self, colour: Rgb) -> Index<Material> {
        let root = &mut self.root;
        *self.materials.entry(colour).or_insert_with(|| {
            let [r, g, b] = colour.linear().map(|value| value as f32);
            let pbr_metallic_roughness = PbrMetallicRoughness {
                base_color_factor: PbrBaseColorFactor([r, g, b, 1.0]),
                metallic_factor: StrengthFactor(0.0),
                roughness_factor: StrengthFactor(0.9),
                ..PbrMetallicRoughness::default()
            };
            root.push(Material { name: Some(colour.hex()), pbr_metallic_roughness, ..Material::default() })
        })
    }

    /// Puts the parts together: a header, the JSON, the numbers; each part a multiple of four bytes.
    fn finish(mut self) -> Vec<u8> {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        if !self.bytes.is_empty() {
            let buffer = Buffer { byte_length: self.bytes.len().into(), name: None, uri: None, extensions: None, extras: None };
            self.root.push(buffer);
        }
        // Plain data of ours always serializes.
        let mut json = self.root.to_vec().unwrap_or_default();
        json.resize(json.len().next_multiple_of(4), b' ');
        let parts = [(*b"JSON", json), (*b"BIN\0", self.bytes)];
        let parts = parts.iter().filter(|(_, bytes)| !bytes.is_empty());
        let total = 12 + parts.clone().map(|(_, bytes)| 8 + bytes.len()).sum::<usize>();
        let mut out = Vec::with_capacity(total);
        out.extend_from_slice(b"glTF");
        let word = |value: usize| u32::try_from(value).unwrap_or(u32::MAX).to_le_bytes();
        out.extend([2_usize, total].map(word).concat());
        for (kind, bytes) in parts {
            out.extend(word(bytes.len()));
            out.extend_from_slice(kind);
            out.extend_from_slice(bytes);
        }
        out
    }
}
