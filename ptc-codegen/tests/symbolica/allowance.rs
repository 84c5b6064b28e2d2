//! Without a licence key Symbolica runs once for each user. Runs take turns; what they cannot have is
//! one clear error.

use std::fs::{self, File};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::channel;
use std::thread::{sleep, spawn};
use std::time::{Duration, Instant};

const SHOW: [&str; 6] = ["show", "r", "--n", "3", "--mu", "exp"];
/// A request that takes much longer than a second: 1.4 million terms, each of which is derived.
const LONG: &str = "{\"n\":16,\"bell\":true,\"r1\":\"v0 v1 v2 v3 +4 200 ^\",\
                    \"derivations\":[[0,\"v1\"],[1,\"v2\"],[2,\"v3\"],[3,\"v0\"]]}\n";
const R2: &str = "r2 = -a^2*T";

/// A lock that is held.
fn held(path: &Path) -> File {
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    let file = File::create(path).expect("a file");
    file.lock().expect("a lock");
    file
}

/// The place of the lock that all runs of this user share, as the program finds it.
fn shared() -> PathBuf {
    let named = |key: &str| std::env::var_os(key).filter(|v| !v.is_empty()).map(PathBuf::from);
    let folder = named("XDG_CACHE_HOME").or_else(|| Some(named("HOME")?.join(".cache")));
    folder.expect("a home").join("ptc-codegen-symbolica.lock")
}

fn start() -> Child {
    let mut command = super::command(&SHOW);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().expect("the binary runs")
}

/// Two runs while a third holds the allowance: both wait, then one after the other succeeds.
#[test]
#[ignore = "needs the engine"]
fn runs_take_turns() {
    let turn = held(&shared());
    let mut waiting = [start(), start()];
    sleep(Duration::from_millis(500));
    for child in &mut waiting {
        assert!(child.try_wait().expect("a child").is_none(), "it did not wait");
    }
    drop(turn);
    for child in waiting {
        let output = child.wait_with_output().expect("a child");
        let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{stderr}");
        let stdout = String::from_utf8(output.stdout).expect("UTF-8");
        assert!(stdout.contains(R2), "{stdout}");
        // Symbolica's own messages are not part of the answer.
        assert!(!stdout.contains("Symbolica"), "{stdout}");
    }
}

#[test]
#[ignore = "needs the engine"]
fn a_turn_that_does_not_come_is_told() {
    let path = super::folder("held").join("lock");
    let _turn = held(&path);
    let began = Instant::now();
    let mut command = super::command(&SHOW);
    command.env("PTC_ENGINE_LOCK", &path).env("PTC_ENGINE_TIMEOUT", "0.2");
    let output = command.output().expect("the binary runs");
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(output.stdout.is_empty());
    assert!(
        stderr.contains("another ptc-codegen has used Symbolica for more than 200ms"),
        "{stderr}"
    );
    assert!(stderr.contains("PTC_ENGINE_TIMEOUT"), "{stderr}");
    assert!(began.elapsed() < Duration::from_secs(20));
}

/// An instance that takes no turn, as another program of the user's, lets Symbolica abort.
#[test]
#[ignore = "needs the engine"]
fn an_abort_names_its_cause() {
    let _turn = held(&shared());
    let mut other = Command::new(super::engine());
    other.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut other = other.spawn().expect("the binary runs");
    let (sender, banner) = channel();
    let lines = BufReader::new(other.stdout.take().expect("a pipe")).lines();
    spawn(move || lines.map_while(Result::ok).try_for_each(|line| sender.send(line)));
    let restricted = banner.recv_timeout(Duration::from_secs(20)).is_ok();
    // A turn of its own, for the shared one is held against the other tests. The other instance has
    // said that it runs a little before it does.
    let path = super::folder("abort").join("lock");
    let mut attempts = (0..20).map(|_| {
        sleep(Duration::from_millis(100));
        super::command(&SHOW).env("PTC_ENGINE_LOCK", &path).output().expect("the binary runs")
    });
    let output = if restricted { attempts.find(|o| o.status.code() != Some(0)) } else { None };
    drop(other.stdin.take());
    let _ = other.wait();
    if !restricted {
        println!("NOT RUN: with a licence key no instance shuts another one out");
        return;
    }
    let output = output.expect("a second instance beside a restricted one");
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(output.stdout.is_empty());
    assert!(stderr.contains("error: Symbolica aborted"), "{stderr}");
    assert!(stderr.contains("https://symbolica.io/license/"), "{stderr}");
}

/// SIGKILL cannot be caught: a worker sees by the end of its request that nobody waits.
#[test]
#[ignore = "needs the engine"]
fn a_worker_ends_with_the_process_that_asks() {
    let _turn = held(&shared());
    let mut worker = Command::new(super::engine());
    worker.stdin(Stdio::piped()).stdout(Stdio::null());
    let mut worker = worker.stderr(Stdio::null()).spawn().expect("the binary runs");
    let mut input = worker.stdin.take().expect("a pipe");
    input.write_all(LONG.as_bytes()).expect("a request");
    // In place of the process that asks: whatever holds the pipe.
    let mut asks = Command::new("sleep").arg("60").stdout(Stdio::from(input)).spawn();
    sleep(Duration::from_secs(1));
    let at_work = worker.try_wait().expect("a child").is_none();
    let asks = asks.as_mut().expect("sleep runs");
    asks.kill().expect("killed");
    asks.wait().expect("ended");
    let killed = Instant::now();
    let status = loop {
        match worker.try_wait().expect("a child") {
            Some(status) => break status,
            None if killed.elapsed() < Duration::from_secs(10) => sleep(Duration::from_millis(10)),
            None => {
                let _ = worker.kill();
                panic!("the worker lives on");
            }
        }
    };
    assert!(at_work && status.code() == Some(3), "{status}, at work: {at_work}");
}
