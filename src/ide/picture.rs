//! A small picture of the scene in which one object is pointed out.

use super::program::Scene;
use crate::check::Rules;
use crate::render::{self, Labels, Options, Picture};
use crate::scene::ObjectId;

/// Scenes of more objects than this take longer to draw than anyone wants to wait for a hover.
const MAX_OBJECTS: usize = 1000;
/// Width and height in pixels.
const SIZE: (u32, u32) = (320, 240);

/// A PNG, seen from above; none where it is about several objects, or the scene is very large.
pub fn picture(scene: &Scene, objects: &[usize]) -> Option<Vec<u8>> {
    let [object] = objects else { return None };
    if scene.layout.objects.len() > MAX_OBJECTS {
        return None;
    }
    let options = Options {
        view: render::View::Top,
        size: SIZE,
        labels: Labels::None,
        errors: false,
        captions: false,
        highlight: Some(ObjectId(u32::try_from(*object).ok()?)),
        ..Options::default()
    };
    let picture = Picture { layout: &scene.layout, verdict: &scene.verdict, rules: &Rules::default() };
    Some(render::draw(&picture, &options).to_png())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ide::tests::scene_of;

    #[test]
    fn one_object_is_pointed_out() {
        let scene = scene_of(
            "a = Object('A', 1, 1, 1)\nb = Object('B', 1, 1, 1)\na.center.x = 1.5\na.center.y = 0.5\nb.center.x = 0.0\nb.center.y = 0.0\n",
            None,
        )
        .unwrap();
        let (first, second) = (picture(&scene, &[0]).unwrap(), picture(&scene, &[1]).unwrap());
        assert!(first.starts_with(b"\x89PNG") && first != second);
        assert_eq!(picture(&scene, &[0, 1]), None);
    }
}
