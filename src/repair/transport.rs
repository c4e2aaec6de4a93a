//! How far a scene is from another, object by object, when objects of one category are alike.

use std::collections::BTreeMap;

use crate::scene::Layout;

use super::measure::volume;

/// Categories with more objects than this are compared in order of declaration: the optimum takes cubic time.
const MAX_ASSIGNED: usize = 1000;

/// Σ volume × distance of centers over the best matching of the objects of `from` with those of `to` that keeps categories. m⁴.
///
/// An object weighs the volume that it has in `from`. Where a category does not have as many objects in both, what is left over counts
/// nothing.
pub fn transport(from: &Layout, to: &Layout) -> f64 {
    let mut categories: BTreeMap<&str, [Vec<usize>; 2]> = BTreeMap::new();
    for (side, layout) in [from, to].into_iter().enumerate() {
        for (index, object) in layout.objects.iter().enumerate() {
            categories.entry(&object.name).or_default()[side].push(index);
        }
    }
    categories.values().map(|[from_here, to_there]| category(from, to, from_here, to_there)).sum()
}

fn category(from: &Layout, to: &Layout, here: &[usize], there: &[usize]) -> f64 {
    let cost = |i: usize, j: usize| {
        let (a, b) = (&from.objects[i].body, &to.objects[j].body);
        let squares = [0, 1, 2].map(|k| (a.center[k] - b.center[k]).powi(2));
        volume(a) * squares.iter().sum::<f64>().sqrt()
    };
    let in_order = || here.iter().zip(there).map(|(i, j)| cost(*i, *j)).sum();
    let size = here.len().max(there.len());
    if !(2..=MAX_ASSIGNED).contains(&size) {
        return in_order();
    }
    let at = |row: usize, column: usize| match (here.get(row), there.get(column)) {
        (Some(i), Some(j)) => cost(*i, *j),
        _ => 0.0,
    };
    let costs: Vec<f64> = (0..size * size).map(|cell| at(cell / size, cell % size)).collect();
    if costs.iter().any(|cost| !cost.is_finite()) {
        return in_order();
    }
    let Ok(matrix) = lapjv::Matrix::from_shape_vec((size, size), costs) else { return in_order() };
    match lapjv::lapjv(&matrix) {
        Ok((columns, _)) => columns.iter().enumerate().map(|(row, column)| at(row, *column)).sum(),
        Err(_) => in_order(),
    }
}
