//! Who may ask: pages of this server only.
//!
//! Any web page can send requests to loopback, and with a name that resolves to 127.0.0.1 it could read the answers.
//! So the Host must be this server's own address, and an Origin, where one is sent, as well.

use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

/// The longest address answered; every param of a large spec fits.
const LONGEST_ADDRESS: usize = 32_768;

/// Headers of every answer: the page may load nothing from elsewhere, and nobody else may embed it. KaTeX gives tall brackets
/// their width in style attributes.
const HEADERS: [(header::HeaderName, &str); 5] = [
    (
        header::CONTENT_SECURITY_POLICY,
        "default-src 'self'; style-src-attr 'unsafe-inline'; img-src 'self' blob: data:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'",
    ),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (header::HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    (header::CACHE_CONTROL, "no-store"),
];

/// Lets a request through if it is a GET from this server's own pages.
pub async fn guard(State(port): State<u16>, request: Request, next: Next) -> Response {
    let refusal = refusal(request.method(), request.headers(), port);
    let mut response = match refusal {
        Some((status, reason)) => (status, reason).into_response(),
        None if request.uri().to_string().len() > LONGEST_ADDRESS => {
            (StatusCode::URI_TOO_LONG, "the address is too long").into_response()
        }
        None => next.run(request).await,
    };
    let headers = response.headers_mut();
    for (name, value) in HEADERS {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}

fn refusal(method: &Method, headers: &HeaderMap, port: u16) -> Option<(StatusCode, &'static str)> {
    let own = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
    let text = |name: header::HeaderName| headers.get(name).map(|value| value.to_str().unwrap_or(""));
    let is_own = |host: &str| own.iter().any(|own| own == host);
    if method != Method::GET && method != Method::HEAD {
        return Some((StatusCode::METHOD_NOT_ALLOWED, "this server answers GET only"));
    }
    if !text(header::HOST).is_some_and(is_own) {
        return Some((StatusCode::FORBIDDEN, "the Host is not this server's address"));
    }
    if text(header::ORIGIN).is_some_and(|origin| !origin.strip_prefix("http://").is_some_and(is_own)) {
        return Some((StatusCode::FORBIDDEN, "the Origin is another site"));
    }
    if text(header::HeaderName::from_static("sec-fetch-site")) == Some("cross-site") {
        return Some((StatusCode::FORBIDDEN, "the request comes from another site"));
    }
    None
}
