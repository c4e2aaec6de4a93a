//! Requests about the scene of a program: `psdl/layout`, `psdl/render`, `psdl/constants`, `psdl/move`, `psdl/turn`.

use super::actions::workspace_edit;
use super::client::Client;
use super::document;
use super::handlers::{Backend, failed, not_open};
use super::run::{self, Outcome};
use super::study::Study;
use crate::ide::{self, Lab, Scene, View};
use crate::render::{self, Labels, Picture, Theme};
use crate::repair::{self, Reach, Watch};
use crate::scene::{Cardinal, ObjectId};
use base64::Engine as _;
use serde::Deserialize;
use serde_json::{Value, json};
use std::sync::Arc;
use tower_lsp_server::jsonrpc::{Error, Result};
use tower_lsp_server::ls_types::{TextDocumentIdentifier, Uri};

/// An answer with more choices than this is of no use.
const CHOICES: usize = 8;

/// What most requests take.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct About {
    text_document: TextDocumentIdentifier,
}

/// An object: its number, or what the program calls it.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
enum Which {
    Index(usize),
    Path(String),
}

/// `psdl/move`
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct MoveParams {
    text_document: TextDocumentIdentifier,
    object: Which,
    to: [Option<f64>; 3],
}

/// `psdl/turn`
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct TurnParams {
    text_document: TextDocumentIdentifier,
    object: Which,
    facing: String,
}

/// `psdl/render`
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct RenderParams {
    text_document: TextDocumentIdentifier,
    format: Format,
    #[serde(default)]
    view: ViewName,
    #[serde(default)]
    width: Option<u32>,
    #[serde(default)]
    height: Option<u32>,
    #[serde(default)]
    theme: ThemeName,
    #[serde(default)]
    labels: LabelsName,
    #[serde(default = "yes")]
    errors: bool,
    #[serde(default)]
    highlight: Option<Which>,
}

fn yes() -> bool {
    true
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Format {
    Svg,
    Png,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum ViewName {
    Top,
    Perspective,
    #[default]
    Both,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum ThemeName {
    #[default]
    Light,
    Dark,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum LabelsName {
    None,
    #[default]
    Some,
    All,
}

/// A program and what is known about it.
struct Seen {
    outcome: Arc<Outcome>,
    /// Of the last run that came to something.
    scene: Option<Arc<Scene>>,
    client: Client,
}

impl Seen {
    /// Does something with what the features of `ide` take.
    fn with_view<T>(&self, work: impl FnOnce(&View) -> T) -> Option<T> {
        let program = self.outcome.program.as_deref()?;
        Some(work(&View::new(program, self.scene.as_deref())))
    }

    /// Whether the scene is not that of the text.
    fn is_stale(&self) -> bool {
        !self.outcome.ran && self.scene.is_some()
    }
}

impl Backend {
    /// A program: as it is open, else as it is on the disk.
    async fn look_at(&self, uri: &Uri) -> Result<Seen> {
        if self.shared.state().documents.contains_key(uri) {
            let (outcome, client) = self.seen(uri).await?;
            let state = self.shared.state();
            let key = state.documents.get(uri).and_then(|document| state.unit_of(document));
            let scene = key.and_then(|(key, _)| state.units.get(&key)?.scene.clone());
            return Ok(Seen { outcome, scene, client });
        }
        let path = document::file_path(uri).filter(|path| path.is_file()).ok_or_else(not_open)?;
        let (job, client) = {
            let state = self.shared.state();
            (state.job_of_file(path), state.client)
        };
        let mut outcome = self.thought(Arc::default(), move |_| run::run(&job)).await?.ok_or_else(Error::internal_error)?;
        let scene = outcome.fresh.take().map(|fresh| fresh.scene);
        Ok(Seen { outcome: Arc::new(outcome), scene, client })
    }

    /// What there is to say about a program: as it is open, else as it is on the disk.
    pub(super) async fn outcome_of(&self, uri: &Uri) -> Result<(Arc<Outcome>, Client)> {
        let seen = self.look_at(uri).await?;
        Ok((seen.outcome, seen.client))
    }

    /// `psdl/layout`
    pub(super) async fn layout(&self, params: About) -> Result<Value> {
        let seen = self.look_at(&params.text_document.uri).await?;
        self.thought(Arc::default(), move |_| seen.layout()).await
    }

    /// `psdl/render`
    pub(super) async fn render(&self, params: RenderParams) -> Result<Value> {
        let seen = self.look_at(&params.text_document.uri).await?;
        self.thought(Arc::default(), move |_| seen.picture(&params)).await?
    }

    /// `psdl/constants`
    pub(super) async fn constants(&self, params: About) -> Result<Value> {
        self.tried(&params.text_document.uri, |study, client, watch| {
            let (problem, names) = study.with_lab(watch, |lab| (lab.problem.clone(), lab.names().clone()))?;
            let text = &study.outcome.main.text;
            let constants = repair::tunables(&problem, &names, Some(&watch.cancelled));
            let path = |object: usize| problem.layout().objects.get(object).map_or("", |object| object.path.as_str());
            let constants: Vec<Value> = constants
                .iter()
                .filter_map(|found| {
                    let constant = problem.tuning().constant(found.id)?;
                    let by = |slope: &[f64; 3]| slope.iter().map(|part| part * part).sum::<f64>().sqrt();
                    let moves = found.moves.iter().map(|(object, slope)| json!({ "path": path(*object), "by": by(slope) }));
                    Some(json!({
                        "range": text.range(constant.range, client), "text": constant.text(problem.text()), "value": constant.value,
                        "name": found.name, "good": found.good, "moves": moves.collect::<Vec<Value>>(), "errors": found.errors,
                    }))
                })
                .collect();
            Some(json!({ "version": text.version, "constants": constants }))
        })
        .await
    }

    /// `psdl/move`
    pub(super) async fn move_object(&self, params: MoveParams) -> Result<Value> {
        let MoveParams { text_document, object, to } = params;
        self.tried(&text_document.uri, move |study, client, watch| {
            let (problem, names) = study.with_lab(watch, |lab| (lab.problem.clone(), lab.names().clone()))?;
            let index = study.with_lab(watch, |lab| object_of(lab, &object))??;
            let choices = repair::move_to(&problem, &names, index, to, Some(&watch.cancelled));
            Some(study.choices(&choices, client, |reach| json!(reach.reached)))
        })
        .await
    }

    /// `psdl/turn`
    pub(super) async fn turn_object(&self, params: TurnParams) -> Result<Value> {
        let TurnParams { text_document, object, facing } = params;
        let facing = Cardinal::ALL.into_iter().find(|cardinal| cardinal.short_name() == facing);
        let facing = facing.ok_or_else(|| Error::invalid_params("a facing is X+, Y+, X- or Y-"))?;
        self.tried(&text_document.uri, move |study, client, watch| {
            let (problem, names) = study.with_lab(watch, |lab| (lab.problem.clone(), lab.names().clone()))?;
            let index = study.with_lab(watch, |lab| object_of(lab, &object))??;
            let choices = repair::turn_to(&problem, &names, index, facing, Some(&watch.cancelled));
            Some(study.choices(&choices, client, |reach| json!(reach.facing.short_name())))
        })
        .await
    }

    /// Has work done with a program run with a record.
    async fn tried(&self, uri: &Uri, work: impl FnOnce(&Study, Client, &Watch) -> Option<Value> + Send + 'static) -> Result<Value> {
        let Seen { outcome, client, .. } = self.look_at(uri).await?;
        let study = self.shared.study(&outcome);
        let found = self.thought(self.shared.watch(uri), move |watch| work(&study, client, watch)).await?;
        found.ok_or_else(|| failed("the program cannot be run as it is, or has no such object"))
    }
}

fn object_of(lab: &Lab, which: &Which) -> Option<usize> {
    let objects = &lab.problem.layout().objects;
    match which {
        Which::Index(index) => (*index < objects.len()).then_some(*index),
        Which::Path(path) => objects.iter().position(|object| object.path == *path),
    }
}

impl Study {
    fn choices(&self, choices: &[Reach], client: Client, reached: impl Fn(&Reach) -> Value) -> Value {
        let text = &self.outcome.main.text;
        let choice = |reach: &Reach| {
            json!({
                "title": reach.title, "edit": workspace_edit(text, &reach.edits, client), "edits": text.text_edits(&reach.edits, client),
                "reached": reached(reach), "exact": reach.exact, "errors": reach.errors,
            })
        };
        json!({ "version": text.version, "choices": choices.iter().take(CHOICES).map(choice).collect::<Vec<Value>>() })
    }
}

impl Seen {
    fn layout(&self) -> Value {
        let text = &self.outcome.main.text;
        let range = |range| text.range(range, self.client);
        let layout = self.with_view(ide::layout_text).flatten().and_then(|layout| serde_json::from_str::<Value>(&layout).ok());
        let places = self.with_view(ide::places).unwrap_or_default();
        let ranges = places.iter().map(|of| {
            let placements: Vec<_> = of.placements.iter().map(|place| range(*place)).collect();
            json!({ "path": of.path, "declaration": of.declaration.map(range), "placements": placements })
        });
        let stale = self.is_stale();
        let findings = self.outcome.main.items.iter().filter_map(|item| {
            let finding = item.finding.as_ref()?;
            // Of a text that could not be run, the numbers of the objects are those of the last scene.
            let diagnostic = &item.diagnostic;
            Some(json!({
                "code": finding.code.name(), "message": diagnostic.message, "range": diagnostic.range, "objects": finding.objects,
            }))
        });
        json!({
            "version": text.version, "stale": stale, "partial": self.scene.as_ref().is_some_and(|scene| scene.partial),
            "layout": layout, "ranges": ranges.collect::<Vec<Value>>(), "findings": findings.collect::<Vec<Value>>(),
        })
    }

    fn picture(&self, params: &RenderParams) -> Result<Value> {
        let scene = self.scene.as_ref().ok_or_else(|| failed("there is no scene: the program cannot be run as it is"))?;
        let paths = || scene.layout.objects.iter().map(|object| object.path.as_str());
        let highlight = match &params.highlight {
            None => None,
            Some(Which::Index(index)) => Some(*index).filter(|index| *index < scene.layout.objects.len()),
            Some(Which::Path(path)) => paths().position(|known| known == path),
        };
        let default = render::Options::default();
        let pixels = |size: Option<u32>, default: u32| size.unwrap_or(default).clamp(*render::SIZES.start(), *render::SIZES.end());
        let options = render::Options {
            view: match params.view {
                ViewName::Top => render::View::Top,
                ViewName::Perspective => render::View::Perspective,
                ViewName::Both => render::View::Both,
            },
            size: (pixels(params.width, default.size.0), pixels(params.height, default.size.1)),
            theme: if matches!(params.theme, ThemeName::Dark) { Theme::Dark } else { Theme::Light },
            labels: match params.labels {
                LabelsName::None => Labels::None,
                LabelsName::Some => Labels::Some,
                LabelsName::All => Labels::All,
            },
            errors: params.errors,
            highlight: highlight.and_then(|index| u32::try_from(index).ok()).map(ObjectId),
            ..default
        };
        let picture = Picture { layout: &scene.layout, verdict: &scene.verdict, rules: &self.outcome.options.rules };
        let drawing = render::draw(&picture, &options);
        let (mime, data) = match params.format {
            Format::Svg => ("image/svg+xml", drawing.to_svg()),
            Format::Png => ("image/png", base64::engine::general_purpose::STANDARD.encode(drawing.to_png())),
        };
        let text = &self.outcome.main.text;
        let places = self.with_view(ide::places).unwrap_or_default();
        let objects = places.iter().enumerate().map(|(index, of)| {
            let place = of.placements.last().copied().or(of.declaration);
            json!({ "path": of.path, "index": index, "range": place.map(|place| text.range(place, self.client)) })
        });
        let objects: Vec<Value> = objects.collect();
        Ok(json!({ "version": text.version, "stale": self.is_stale(), "mime": mime, "data": data, "objects": objects }))
    }
}
