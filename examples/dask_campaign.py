"""A verification campaign in shards on a Dask cluster, merged to the bytes of one run.

    pip install "dask[distributed]"
    python examples/dask_campaign.py roll.toml --shards 16 --out roll.parquet

Without --scheduler the cluster is a local one of two workers. Elsewhere the folder of --out has to
be one that all workers share. What is written after `--command` is the program, with its first
arguments; the exit code is that of `ptc-codegen verify --merge`.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from pathlib import Path

from dask.distributed import Client, LocalCluster, get_worker


def shard(command: list[str], design: str, part: int, parts: int, out: str) -> str:
    """Runs one part and returns the worker's name; an interrupted part resumes where it stopped."""
    asked = [*command, "verify", design, "--shard", f"{part}/{parts}", "--out", out]
    # Dask gives a worker one shard at a time for each of its threads.
    done = subprocess.run(
        asked, env={**os.environ, "RAYON_NUM_THREADS": "1"}, capture_output=True, text=True
    )
    if done.returncode != 0:
        raise RuntimeError(f"part {part}/{parts}: {done.stderr.strip()}")
    return str(get_worker().name)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("design", type=Path)
    parser.add_argument("--shards", type=int, default=16)
    parser.add_argument("--out", type=Path, default=Path("campaign.parquet"))
    parser.add_argument("--scheduler", help="address of a scheduler, such as tcp://host:8786")
    parser.add_argument("--command", nargs="+", default=["ptc-codegen"])
    asked = parser.parse_args()
    design, out = str(asked.design.resolve()), asked.out.resolve()
    out.parent.mkdir(parents=True, exist_ok=True)
    parts = [str(out.with_suffix(f".part{i}.parquet")) for i in range(1, asked.shards + 1)]
    cluster = asked.scheduler or LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None
    )
    with Client(cluster) as client:
        futures = [
            # A command is no pure function: what a failed run left is not to be taken for its result.
            client.submit(shard, asked.command, design, i, asked.shards, part, pure=False)
            for i, part in enumerate(parts, 1)
        ]
        workers = client.gather(futures)
    print(f"{asked.shards} shards on {len(set(workers))} workers", flush=True)
    merge = [*asked.command, "verify", design, "--merge", *parts, "--out", str(out)]
    code = subprocess.run(merge).returncode
    for part in parts:
        Path(part).unlink()
    return code


if __name__ == "__main__":
    sys.exit(main())
