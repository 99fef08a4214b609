"""Motion graphs: their pages, and the API by which they are kept and walked through."""

from __future__ import annotations

from fastapi import APIRouter, Depends, Request, Response
from fastapi.responses import HTMLResponse

from app.dependencies import (
    CurrentDatabase,
    CurrentWorkers,
    CurrentWriter,
    Reading,
    SignedIn,
    key_writer,
    reader,
)
from app.pages import render
from app.schemas.errors import BUSY, ERRORS
from app.schemas.graphs import (
    GraphDetail,
    GraphList,
    GraphRequest,
    GraphShape,
    GraphTransitions,
    Piece,
    PlayRequest,
)
from app.services import graphs

router = APIRouter(include_in_schema=False)
api = APIRouter(prefix="/api/v1/graphs", tags=["graphs"], responses={**ERRORS, **BUSY})
readers = [Depends(reader)]
writers = [Depends(key_writer)]


@router.get("/graphs")
def graphs_page(request: Request, _: SignedIn) -> HTMLResponse:
    """Every graph; a script asks the API for them."""
    return render(request, "graphs.html", section="graphs")


@router.get("/graphs/{graph_id}")
def graph_page(request: Request, graph_id: str, db: Reading, _: SignedIn) -> HTMLResponse:
    """One graph to be looked at, changed and walked through."""
    return render(request, "graph.html", graph=graphs.view(db, graph_id), section="graphs")


@api.get("", dependencies=readers)
def list_graphs(db: Reading) -> GraphList:
    """All motion graphs, the sample first."""
    return graphs.listed(db)


@api.post("", status_code=201, dependencies=writers)
def create_graph(
    graph: GraphRequest,
    response: Response,
    database: CurrentDatabase,
    writer: CurrentWriter,
    workers: CurrentWorkers,
) -> GraphDetail:
    """Keep a graph of clips that have one skeleton and one frame rate."""
    made = graphs.create(database, writer, workers, graph)
    response.headers["Location"] = f"/api/v1/graphs/{made.id}"
    return made


@api.post("/preview", dependencies=readers)
def preview_graph(
    shape: GraphShape, database: CurrentDatabase, workers: CurrentWorkers
) -> GraphTransitions:
    """The transitions that a graph would have. Nothing is stored."""
    return graphs.preview(database, workers, shape)


@api.get("/{graph_id}", dependencies=readers)
def show_graph(graph_id: str, database: CurrentDatabase, workers: CurrentWorkers) -> GraphDetail:
    """A graph with its transitions; the sample's id is `sample`."""
    return graphs.detail(database, workers, graph_id)


@api.put("/{graph_id}", dependencies=writers)
def change_graph(
    graph_id: str,
    graph: GraphRequest,
    database: CurrentDatabase,
    writer: CurrentWriter,
    workers: CurrentWorkers,
) -> GraphDetail:
    """Put a graph in the place of one that is there; the sample cannot be changed."""
    return graphs.change(database, writer, workers, graph_id, graph)


@api.delete("/{graph_id}", status_code=204, dependencies=writers)
def delete_graph(graph_id: str, writer: CurrentWriter) -> None:
    """Delete a graph; its clips stay."""
    graphs.delete(writer, graph_id)


@api.post("/{graph_id}/play", dependencies=readers)
def play_graph(
    graph_id: str, wanted: PlayRequest, database: CurrentDatabase, workers: CurrentWorkers
) -> Piece:
    """The next piece of a walk through the graph.

    The server remembers nothing: what it gives back as `after` is the place of the next request.
    """
    return graphs.play(database, workers, graph_id, wanted)
