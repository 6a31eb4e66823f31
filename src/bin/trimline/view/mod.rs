//! `trimline view`: a page on this machine that shows the surface and follows the spec as it is edited.
//!
//! The server answers GET on loopback and nothing else; it serves the page that is part of the binary and what it
//! works out from the one spec it was given. Every answer is a function of the spec's text and the address asked for:
//! the page keeps its own slider positions and sends them with each question, so several pages do not disturb each
//! other. Where the surface is a sum of products, the page works out positions itself, from the basis as a program and the
//! functions of u as series, or it is a B-spline (see `form`), so moving through time asks nothing; otherwise it asks for
//! vertices.

mod answer;
mod export;
mod form;
mod gaps;
mod guard;
mod live;
mod motion;
mod pieces;
mod residual;
mod server;
mod vertices;
mod watch;

use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;

use clap::Args;

use crate::Outcome;
use crate::failure::{Failure, say};
use crate::options::{Collocation, Solving, Terminal};
use crate::output;
use live::Live;

#[derive(Args)]
pub struct Arguments {
    /// The spec file, or `-`; a file is read again whenever it is saved.
    spec: String,

    #[command(flatten)]
    solving: Solving,

    #[command(flatten)]
    collocation: Collocation,

    /// The port on 127.0.0.1; 0 takes a free one.
    #[arg(long, value_name = "N", default_value_t = 8765)]
    port: u16,
}

pub fn run(arguments: Arguments, terminal: &Terminal) -> Outcome {
    // A broken spec is shown in the page, where it is mended; one that does not exist is a slip of the finger.
    let live = Live::open(arguments.spec, arguments.solving, arguments.collocation.points)?;
    live.print_findings(terminal);
    let live = Arc::new(live);
    let machine = |what: &str, error: &dyn std::fmt::Display| Failure::Machine(format!("cannot {what}: {error}"));
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(1)
        .max_blocking_threads(server::MOST_AT_ONCE)
        .enable_all()
        .build()
        .map_err(|error| machine("start the server", &error))?;
    runtime.block_on(async {
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, arguments.port));
        let listener = tokio::net::TcpListener::bind(address)
            .await
            .map_err(|error| machine(&format!("listen on {address} (another port: --port N)"), &error))?;
        let address = listener.local_addr().map_err(|error| machine("listen", &error))?;
        watch::follow(&live).map_err(|error| machine("watch the spec", &error))?;
        output::print(&format!("http://{address}/\n"))?;
        if !terminal.quiet {
            say("open the address in a browser; Ctrl-C ends the view");
        }
        let routes = server::routes(live, address.port());
        axum::serve(listener, routes).await.map_err(|error| machine("serve", &error))
    })
}
