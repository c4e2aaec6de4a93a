//! From the calls of a program to violations and findings, for scenes of several sizes.

use std::hint::black_box;

use criterion::{BatchSize, BenchmarkId, Criterion, criterion_group, criterion_main};
use psdl::check::{Rules, check, findings};
use psdl::scene::{Anchor, Axis, FacingSpec, Given, Kind, Layout, NewObject, Origins, Scalar, Support, Target, World};
use psdl::trace::{Handle, Plain};

/// A square grid of chairs, a door among every fifty, `spacing` metres apart, their bottoms at `bottom`.
fn world(count: usize, spacing: f64, bottom: f64) -> World {
    let mut world = World::new();
    let origin = Origins::NOWHERE;
    world.set_size(&mut Plain, &[120.0, 120.0, 5.0].map(Given::from)).expect("a good size");
    let side = (count as f64).sqrt().ceil();
    for i in 0..count {
        let kind = if i % 50 == 0 { Kind::Door } else { Kind::Object };
        let (dims, support) = ([0.5, 0.5, 1.0].map(Given::from), Scalar::int(Support::Standing as i64).into());
        let new = NewObject { kind, name: "Chair", dims, support, color: None, dynamic: false };
        let id = world.add_object(&mut Plain, &new, origin).expect("a good object");
        let [x, y] = [(i as f64) % side, (i as f64 / side).floor()].map(|step| (step - 0.5 * side) * spacing);
        for (anchor, axis, value) in [(Anchor::Center, Axis::X, x), (Anchor::Center, Axis::Y, y), (Anchor::Min, Axis::Z, bottom)] {
            world.write(&mut Plain, Target::Object(id), anchor, axis, &value.into(), origin).expect("a good number");
        }
        world.set_facing(&mut Plain, id, &FacingSpec::Number(Scalar::int(1)), Handle::NONE, origin).expect("a good facing");
    }
    world
}

fn layout(count: usize, spacing: f64, bottom: f64) -> Layout {
    world(count, spacing, bottom).into_layout(&mut Plain)
}

fn benches(criterion: &mut Criterion) {
    let rules = Rules::default();
    let scenes = [("spread", 1.0, 0.0), ("touching", 0.5, 0.0), ("floating", 1.0, 0.5)];
    let mut group = criterion.benchmark_group("check");
    for count in [160, 10_000] {
        for (name, spacing, bottom) in scenes {
            let layout = layout(count, spacing, bottom);
            group.bench_function(BenchmarkId::new(name, count), |bench| bench.iter(|| check(black_box(&layout), &rules)));
        }
    }
    let crowd = layout(3_000, 0.01, 0.0);
    group.sample_size(20).bench_function(BenchmarkId::new("crowd", 3_000), |bench| bench.iter(|| check(black_box(&crowd), &rules)));
    group.finish();

    let mut group = criterion.benchmark_group("scene");
    for count in [160, 10_000] {
        group.bench_function(BenchmarkId::new("calls", count), |bench| bench.iter(|| world(black_box(count), 1.0, 0.0)));
        group.bench_function(BenchmarkId::new("layout", count), |bench| {
            bench.iter_batched(|| world(count, 1.0, 0.0), |world| world.into_layout(&mut Plain), BatchSize::LargeInput);
        });
        let layout = layout(count, 1.0, 0.5);
        let verdict = check(&layout, &rules);
        group.bench_function(BenchmarkId::new("findings", count), |bench| bench.iter(|| findings(black_box(&layout), &verdict, &rules)));
    }
    group.finish();
}

criterion_group!(check_benches, benches);
criterion_main!(check_benches);
