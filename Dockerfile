# One image for the server, the scheduler and the workers.
FROM node:22-bookworm-slim AS front-end
WORKDIR /build/static
COPY static/package.json static/package-lock.json static/.npmrc ./
RUN npm ci --no-audit --no-fund
COPY static/ ./
RUN npm run build

FROM python:3.11-slim-bookworm
ENV PYTHONUNBUFFERED=1 PIP_NO_CACHE_DIR=1
WORKDIR /srv/manner
COPY pyproject.toml constraints.txt README.md LICENSE ./
COPY app app
COPY motion motion
RUN pip install -c constraints.txt -e '.[postgres]' \
    && useradd --system --home /srv/manner manner \
    && install -d -o manner /data
COPY migrations migrations
COPY templates templates
COPY --from=front-end /build/static/dist static/dist
USER manner
ENV MANNER_DATA_DIRECTORY=/data MANNER_LOG_FORMAT=json
VOLUME /data
EXPOSE 8000
HEALTHCHECK --interval=30s --timeout=5s --start-period=120s \
    CMD ["python", "-c", "import urllib.request as r; r.urlopen('http://127.0.0.1:8000/health', timeout=4)"]
CMD ["sh", "-c", "manner prepare && exec manner serve --host 0.0.0.0"]
