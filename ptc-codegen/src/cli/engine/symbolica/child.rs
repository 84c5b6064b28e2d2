//! A worker as a child process: a request goes in, an answer comes out, or one clear error.

use std::io::{self, Read, Write};
use std::path::PathBuf;
use std::process::{Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use std::{fmt, thread};

use serde_json::Value;

use super::words::{MARK, REFUSED};

/// Time between two looks at the child.
const PAUSE: Duration = Duration::from_millis(5);

/// Time for which the pipes of a child that has ended are still read: its output is there, and a process that it
/// started may hold them open for as long as it likes.
const GRACE: Duration = Duration::from_secs(1);

/// Last lines of a child that are shown with an error.
const SAID: usize = 12;

/// Why there is no answer.
#[derive(Debug)]
pub(super) enum Wrong {
    /// The child cannot be started, or waited for.
    Start(io::Error),
    /// The lock cannot be had, for want of a place.
    Place(PathBuf, io::Error),
    /// The lock was held too long.
    Busy(PathBuf, Duration),
    /// The child took too long.
    Late(Duration),
    /// The child aborted, with what it said.
    Aborted(String),
    /// The child ended otherwise than by an answer, with what it said.
    Ended(ExitStatus, String),
    /// The child did not understand its request, with what it said.
    Refused(String),
    /// The answer of the child is garbled.
    Garbled(String),
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start(error) if error.kind() == io::ErrorKind::NotFound => {
                f.write_str("the engine `symbolica` needs the program `ptc-engine-symbolica`, which is not installed")
            }
            Self::Start(error) => write!(f, "Symbolica's process cannot be run: {error}"),
            Self::Place(path, error) => write!(f, "cannot lock {}: {error}", path.display()),
            Self::Busy(path, limit) => write!(
                f,
                "another ptc-codegen has used Symbolica for more than {limit:?}: it holds {}",
                path.display()
            ),
            Self::Late(limit) => write!(f, "Symbolica gave no answer within {limit:?}"),
            Self::Aborted(_) => {
                f.write_str("Symbolica aborted, as it does where its licence does not let it run")
            }
            Self::Ended(status, _) => {
                write!(f, "Symbolica's process ended without an answer, by {status}")
            }
            Self::Refused(_) => f.write_str("Symbolica's process did not understand its request"),
            Self::Garbled(_) => {
                f.write_str("Symbolica's process gave an answer that is no closed form")
            }
        }
    }
}

impl Wrong {
    /// Returns the output of the child, by lines.
    pub(super) fn said(&self) -> Vec<String> {
        let (Self::Aborted(said)
        | Self::Ended(_, said)
        | Self::Refused(said)
        | Self::Garbled(said)) = self
        else {
            return Vec::new();
        };
        let frame = |c: char| c.is_whitespace() || ('\u{2500}'..='\u{257f}').contains(&c);
        let lines = said.lines().map(|line| line.trim_matches(frame)).filter(|l| !l.is_empty());
        let lines: Vec<String> = lines.map(|line| line.chars().take(120).collect()).collect();
        lines[lines.len().saturating_sub(SAID)..].to_vec()
    }
}

/// Runs `command` on `request` for at most `limit` and reads its answer. What it says to the user
/// beside that goes to the standard error. The request is one line; what it came by stays open until
/// the child has ended, so that a child sees by its end that nobody waits for it any more.
pub(super) fn ask(mut command: Command, request: &str, limit: Duration) -> Result<Value, Wrong> {
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(Wrong::Start)?;
    // Holds the pipe once the request is written.
    let (written, pipe) = channel();
    if let Some(mut input) = child.stdin.take() {
        let request = format!("{request}\n");
        thread::spawn(move || {
            // A child that reads nothing is reported by its exit status.
            let _ = input.write_all(request.as_bytes());
            // Where nobody waits any more, the pipe ends here.
            let _ = written.send(input);
        });
    }
    let (output, complaint) = (Drain::of(child.stdout.take()), Drain::of(child.stderr.take()));
    let began = Instant::now();
    let status = loop {
        match child.try_wait() {
            Ok(Some(status)) => break status,
            Ok(None) if began.elapsed() < limit => thread::sleep(PAUSE),
            late => {
                // It may have ended by itself meanwhile.
                let _ = child.kill();
                let _ = child.wait();
                return Err(late.map_or_else(Wrong::Start, |_| Wrong::Late(limit)));
            }
        }
    };
    drop(pipe);
    let said = format!("{}\n{}", output.text(), complaint.text());
    if !status.success() {
        return Err(match status.code() {
            _ if aborted(status) => Wrong::Aborted(said),
            Some(code) if code == i32::from(REFUSED) => Wrong::Refused(said),
            _ => Wrong::Ended(status, said),
        });
    }
    let (answer, said): (Vec<_>, Vec<_>) =
        said.lines().map(str::to_owned).partition(|line| line.starts_with(MARK));
    let read = |line: &String| serde_json::from_str(line.strip_prefix(MARK)?).ok();
    let answer = answer.first().and_then(read).ok_or_else(|| {
        let lines = answer.iter().chain(&said).cloned().collect::<Vec<_>>();
        Wrong::Garbled(lines.join("\n"))
    })?;
    // If the standard error is closed, there is nowhere to report it.
    let _ = io::stderr().write_all(said.join("\n").trim_matches('\n').as_bytes());
    let _ = io::stderr().write_all(b"\n");
    Ok(answer)
}

/// Reader of a pipe, in the background so that the child never waits for it.
struct Drain {
    bytes: Arc<Mutex<Vec<u8>>>,
    ended: Receiver<()>,
}

impl Drain {
    fn of(pipe: Option<impl Read + Send + 'static>) -> Self {
        let (sender, ended) = channel();
        let bytes = Arc::<Mutex<Vec<u8>>>::default();
        let kept = Arc::clone(&bytes);
        thread::spawn(move || {
            let mut block = [0; 1 << 13];
            if let Some(mut pipe) = pipe {
                while let Ok(read @ 1..) = pipe.read(&mut block) {
                    let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
                    kept.extend_from_slice(&block[..read]);
                }
            }
            // Nobody is left to hear of it where the child was late.
            let _ = sender.send(());
        });
        Self { bytes, ended }
    }

    /// All of it, of a child that has ended.
    fn text(&self) -> String {
        let _ = self.ended.recv_timeout(GRACE);
        let bytes = self.bytes.lock().unwrap_or_else(PoisonError::into_inner);
        String::from_utf8_lossy(&bytes).into_owned()
    }
}

#[cfg(unix)]
fn aborted(status: ExitStatus) -> bool {
    use std::os::unix::process::ExitStatusExt;
    const SIGABRT: i32 = 6;
    status.signal() == Some(SIGABRT)
}

#[cfg(not(unix))]
fn aborted(status: ExitStatus) -> bool {
    // How the C library and Rust abort there: by the code 3, and by a fast fail.
    const FAST_FAIL: i32 = -1_073_740_791;
    matches!(status.code(), Some(3 | FAST_FAIL))
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    /// Returns the result of a shell in place of a worker.
    fn shell(script: &str) -> Result<Value, Wrong> {
        let mut command = Command::new("sh");
        command.args(["-c", script]);
        ask(command, "{}", Duration::from_secs(20))
    }

    #[test]
    fn answer_is_read_from_its_own_line() {
        let answer = shell("echo banner; read request; echo 'ptc-answer: [1]'; echo more");
        assert_eq!(answer.expect("an answer"), serde_json::json!([1]));
    }

    #[test]
    fn background_process_does_not_delay_the_answer() {
        let began = Instant::now();
        let answer = shell("sleep 30 & echo 'ptc-answer: [1]'");
        assert_eq!(answer.expect("an answer"), serde_json::json!([1]));
        assert!(began.elapsed() < Duration::from_secs(15));
    }

    #[test]
    fn process_that_never_reads_does_not_block_the_request() {
        let mut command = Command::new("sh");
        command.args(["-c", "sleep 30 <&0 & echo 'ptc-answer: [1]'"]);
        // More than a pipe takes.
        let request = "x".repeat(1 << 20);
        let began = Instant::now();
        let answer = ask(command, &request, Duration::from_secs(20));
        assert_eq!(answer.expect("an answer"), serde_json::json!([1]));
        assert!(began.elapsed() < Duration::from_secs(15));
    }

    #[test]
    fn the_request_stays_open_until_the_child_ends() {
        // `timeout` ends a reader that waits on by 124.
        let answer = shell("read request; timeout 0.3 cat; echo \"ptc-answer: [$?]\"");
        assert_eq!(answer.expect("an answer"), serde_json::json!([124]));
    }

    #[test]
    fn message_names_the_exit_cause() {
        for (script, wanted, said) in [
            ("echo no room >&2; kill -ABRT $$", "Symbolica aborted, as it does", "no room"),
            ("echo half; kill -KILL $$", "ended without an answer, by signal: 9", "half"),
            ("echo why >&2; exit 101", "ended without an answer, by exit status: 101", "why"),
            ("exit 3", "did not understand its request", ""),
            ("echo nothing", "no closed form", "nothing"),
            ("echo 'ptc-answer: {\"r\":['", "no closed form", "ptc-answer: {\"r\":["),
        ] {
            let wrong = shell(script).expect_err(script);
            assert!(wrong.to_string().contains(wanted), "{script}: {wrong}");
            assert_eq!(wrong.said().last().map_or("", String::as_str), said, "{script}");
        }
    }

    #[test]
    fn slow_child_is_killed_at_the_timeout() {
        let mut command = Command::new("sleep");
        command.arg("60");
        let began = Instant::now();
        let wrong = ask(command, "{}", Duration::from_millis(50)).expect_err("no answer");
        assert_eq!(wrong.to_string(), "Symbolica gave no answer within 50ms");
        assert!(began.elapsed() < Duration::from_secs(20));
    }

    #[test]
    fn failed_start_is_reported() {
        let wrong = ask(Command::new("/nowhere/worker"), "{}", Duration::from_secs(1));
        assert!(matches!(wrong, Err(Wrong::Start(_))));
    }

    #[test]
    fn last_output_lines_are_shown_without_their_frame() {
        let banner: String = (0..40).map(|i| format!("\u{2502} line {i}  \u{2502}\n")).collect();
        let said = Wrong::Garbled(banner).said();
        assert_eq!((said.len(), said.last().map(String::as_str)), (SAID, Some("line 39")));
    }
}
