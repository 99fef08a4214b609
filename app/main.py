"""Puts the server together."""

from __future__ import annotations

import gc
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from importlib.metadata import version
from pathlib import Path

from fastapi import APIRouter, FastAPI
from starlette.middleware.gzip import DEFAULT_EXCLUDED_CONTENT_TYPES, GZipMiddleware

from app import error_handling
from app.assets import Assets, BuiltFiles
from app.logs import LogMiddleware, configure_logs
from app.pages import make_templates
from app.persistence.engine import Database, make_engine
from app.persistence.writer import Writer
from app.routes import (
    batches,
    builder,
    catalogue,
    edits,
    exports,
    graphs,
    health,
    imports,
    impressions,
    keys,
    library,
    live,
    media,
    pages,
    participant,
    research,
    research_auth,
    retargets,
    sessions_api,
    sets,
    spaces,
    studies_api,
    studio,
)
from app.schemas.errors import ERRORS
from app.security import (
    AttemptLimiter,
    BodyLimitMiddleware,
    CsrfMiddleware,
    HeadersMiddleware,
    MotionLimiter,
    SignInCookies,
)
from app.services.downloads import ClipFiles
from app.services.job_pool import JobPool
from app.services.job_runner import JobRunner
from app.services.keeper import Keeper
from app.services.keys import KeyUses
from app.services.media import MediaStore
from app.settings import PROJECT, Settings
from app.workers import Workers

BUILT = PROJECT / "static" / "dist"
ROUTERS = (
    sessions_api.router,  # first: answers come by the hundred in a second
    pages.router,
    library.router,
    edits.router,
    retargets.router,
    catalogue.router,
    graphs.router,
    graphs.api,
    imports.router,
    media.router,
    health.router,
    research_auth.router,
    participant.router,
    builder.router,
    live.router,
    live.api,
    research.router,
    research.api,
    impressions.router,
    impressions.api,
    studies_api.api,
    studies_api.templates,
    studies_api.in_the_making,
    exports.router,
    keys.router,
    batches.router,
    sets.router,
    studio.router,
    spaces.router,
    spaces.api,
    spaces.keytimes_api,
)


def _together() -> APIRouter:
    together = APIRouter(
        responses={422: ERRORS[422]},  # instead of FastAPI's own shape
        generate_unique_id_function=lambda route: route.name,
    )
    for router in ROUTERS:
        together.include_router(router)
    return together


# FastAPI works out what a route takes and gives when it is first asked for, in a fifth of a second
# for all of them: once a process, not once a server.
ROUTES = _together().routes


def create_app(settings: Settings | None = None, built: Path = BUILT) -> FastAPI:
    """The server with these settings (or the environment's) and this built front end."""
    settings = settings or Settings()
    configure_logs(settings)
    app = FastAPI(
        title="Manner",
        version=version("manner"),
        description="Perception studies of human motion: clips, imports, sessions and answers.",
        routes=ROUTES,
        openapi_url="/api/v1/openapi.json",
        docs_url=None,  # their scripts come from elsewhere, which the content policy forbids
        redoc_url=None,
        lifespan=_lifespan,
    )
    app.state.settings = settings
    app.state.database = Database(make_engine(settings.database))
    app.state.media = MediaStore(app.state.database)
    app.state.templates = make_templates(Assets(built))
    app.state.sign_in_cookies = SignInCookies(settings)
    app.state.attempt_limiter = AttemptLimiter(settings.sign_in_attempts)
    app.state.motion_limiter = MotionLimiter()
    app.state.key_uses = KeyUses()
    error_handling.install(app)
    _add_middleware(app, settings)
    app.mount("/static", BuiltFiles(directory=built, check_dir=False), name="static")
    return app


def app_to_serve() -> FastAPI:
    """The server of a process that does nothing else.

    What is loaded by now stays as long as the process. Told so, the garbage collector no longer
    walks through all of it again and again, each time holding every answer up for 0.15 s.
    """
    app = create_app()
    gc.collect()
    gc.freeze()
    return app


@asynccontextmanager
async def _lifespan(app: FastAPI) -> AsyncIterator[None]:
    app.state.writer = Writer(app.state.database)
    app.state.workers = Workers(module="app.services.rendering")
    app.state.clip_files = ClipFiles(app.state.database, app.state.workers)
    pool = JobPool(app.state.settings.scheduler)
    app.state.jobs = JobRunner(app.state.database, app.state.writer, pool)
    app.state.keeper = Keeper(app.state.database, app.state.writer)
    yield
    app.state.keeper.close()
    app.state.jobs.close()
    app.state.workers.close()
    app.state.writer.close()  # what was handed in is still stored
    app.state.database.engine.dispose()


def _add_middleware(app: FastAPI, settings: Settings) -> None:
    # The last one added is the outermost.
    app.add_middleware(BodyLimitMiddleware, settings.request_limit, settings.upload_limit)
    app.add_middleware(CsrfMiddleware, settings.signing_key, settings.secure)
    app.add_middleware(
        GZipMiddleware,
        minimum_size=1000,
        compresslevel=6,
        # Each preview is another file: compressing it would take longer than sending it.
        exclude_content_types=(*DEFAULT_EXCLUDED_CONTENT_TYPES, "model/gltf-binary"),
    )
    app.add_middleware(LogMiddleware)
    app.add_middleware(HeadersMiddleware, settings.secure)
