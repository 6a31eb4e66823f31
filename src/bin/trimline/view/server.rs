//! The routes: the page, events, and answers as JSON.

use std::convert::Infallible;
use std::sync::Arc;

use axum::extract::{Query, State};
use axum::http::{StatusCode, header};
use axum::response::sse::{Event, KeepAlive, Sse};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use axum::{Json, Router, middleware};
use serde_json::json;
use tokio::sync::Semaphore;
use tokio_stream::wrappers::WatchStream;
use tokio_stream::{Stream, StreamExt};

use super::answer::Scene;
use super::export;
use super::gaps;
use super::guard::guard;
use super::live::Live;
use super::motion;
use super::residual;
use super::vertices;
use crate::failure::Failure;
use crate::finding::Finding;

/// Questions that are being answered or wait for it; further ones are refused.
pub const MOST_AT_ONCE: usize = 8;
/// Pages that listen for changes.
const MOST_LISTENERS: usize = 64;

/// What every route sees.
struct Service {
    live: Arc<Live>,
    questions: Arc<Semaphore>,
    listeners: Arc<Semaphore>,
}

/// What the page wants to know: its instant and its values.
pub struct Question {
    pub time: Option<f64>,
    /// `NAME=EXPR`, each.
    pub changes: Vec<String>,
    /// Everything else.
    pub options: Vec<(String, String)>,
}

impl Question {
    /// `t=0.3&set=h1=-2&set=…`; the last of several values counts.
    fn read(pairs: Vec<(String, String)>) -> Result<Question, Failure> {
        let mut question = Question { time: None, changes: Vec::new(), options: Vec::new() };
        for (key, value) in pairs {
            match key.as_str() {
                "t" => {
                    let time = value.parse().ok().filter(|time: &f64| time.is_finite());
                    question.time =
                        Some(time.ok_or_else(|| Failure::Usage(format!("the instant `{value}` is not a number")))?);
                }
                "set" => question.changes.push(value),
                _ => question.options.push((key, value)),
            }
        }
        Ok(question)
    }

    /// The option called `name`.
    pub fn option(&self, name: &str) -> Option<&str> {
        self.options.iter().rev().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }
}

/// Every route, for a server at `port`.
pub fn routes(live: Arc<Live>, port: u16) -> Router {
    let service = Service {
        live,
        questions: Arc::new(Semaphore::new(MOST_AT_ONCE)),
        listeners: Arc::new(Semaphore::new(MOST_LISTENERS)),
    };
    Router::new()
        .route("/", get(|| async { asset("text/html; charset=utf-8", include_bytes!("../viewer/dist/index.html")) }))
        .route("/viewer.js", get(|| async { asset("text/javascript", include_bytes!("../viewer/dist/viewer.js")) }))
        .route("/viewer.css", get(|| async { asset("text/css", include_bytes!("../viewer/dist/viewer.css")) }))
        .route("/events", get(events))
        .route("/scene", get(|service, query| answer(service, query, |live, asked| Ok(Json(Scene::of(live, asked))))))
        .route("/motion", get(|service, query| answer(service, query, |live, asked| motion::of(live, asked).map(Json))))
        .route(
            "/residual",
            get(|service, query| answer(service, query, |live, asked| residual::of(live, asked).map(Json))),
        )
        .route("/gaps", get(|service, query| answer(service, query, |live, asked| gaps::of(live, asked).map(Json))))
        .route("/vertices", get(|service, query| answer(service, query, vertices::of)))
        .route("/export", get(|service, query| answer(service, query, export::of)))
        .layer(middleware::from_fn_with_state(port, guard))
        .with_state(Arc::new(service))
}

fn asset(kind: &'static str, bytes: &'static [u8]) -> impl IntoResponse {
    ([(header::CONTENT_TYPE, kind)], bytes)
}

/// Runs `work` where it may take its time; a failure becomes its findings.
async fn answer<T: IntoResponse + 'static>(
    State(service): State<Arc<Service>>,
    Query(pairs): Query<Vec<(String, String)>>,
    work: impl FnOnce(&Live, &Question) -> Result<T, Failure> + Send + 'static,
) -> Response {
    let Ok(_turn) = Arc::clone(&service.questions).try_acquire_owned() else {
        return refused(StatusCode::SERVICE_UNAVAILABLE, &[]);
    };
    let live = Arc::clone(&service.live);
    let work = move || match Question::read(pairs).and_then(|question| work(&live, &question)) {
        Ok(result) => result.into_response(),
        Err(failure) => {
            let status = match failure {
                Failure::Usage(_) => StatusCode::BAD_REQUEST,
                Failure::Machine(_) => StatusCode::INTERNAL_SERVER_ERROR,
                _ => StatusCode::UNPROCESSABLE_ENTITY,
            };
            refused(status, &Finding::of_failure(&failure))
        }
    };
    let answered = tokio::task::spawn_blocking(work).await;
    answered.unwrap_or_else(|_| refused(StatusCode::INTERNAL_SERVER_ERROR, &[]))
}

fn refused(status: StatusCode, findings: &[Finding]) -> Response {
    (status, Json(json!({ "findings": findings }))).into_response()
}

/// The number of the reading, now and whenever the spec was read again.
async fn events(
    State(service): State<Arc<Service>>,
) -> Result<Sse<impl Stream<Item = Result<Event, Infallible>>>, StatusCode> {
    let listener = Arc::clone(&service.listeners).try_acquire_owned().map_err(|_| StatusCode::SERVICE_UNAVAILABLE)?;
    let revisions = WatchStream::new(service.live.revision.subscribe());
    let events = revisions.map(move |revision| {
        // Held as long as the page listens.
        let _listener = &listener;
        Ok(Event::default().data(revision.to_string()))
    });
    Ok(Sse::new(events).keep_alive(KeepAlive::default()))
}
