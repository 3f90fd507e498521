//! The folder that a study's results are kept in: the study and its scene, as they were
//! computed, and logs of results, one a shard, that are only ever added to.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process;

use super::super::Failure;
use super::super::draw::named;
use super::super::input::{BadInput, origin};
use crate::study::log::{self, CHUNK_HEAD_BYTES, HEAD_BYTES, Head, HeadError};
use crate::study::{Ranges, Row, Study, StudyFile};

/// The study that was computed; one may explore it again.
pub(super) const STUDY: &str = "results.study.toml";
/// Its scene.
const SCENE: &str = "results.scene.toml";
/// All rows, once they are there.
const CSV: &str = "results.csv";

/// A folder of a study's results, which need not be there.
pub(super) struct Folder<'a> {
    path: &'a Path,
    study: &'a Study,
}

/// A log that was read through.
pub(super) struct Log {
    path: PathBuf,
    width: u32,
    chunks: Vec<Chunk>,
    /// Bytes up to the end of the last whole chunk, or of the head; 0 without a head.
    whole: u64,
}

/// A chunk that is whole.
#[derive(Clone)]
pub(super) struct Chunk {
    /// Its samples.
    pub samples: Range<u64>,
    /// Where in the file it begins, and its bytes.
    at: u64,
    bytes: usize,
}

/// A log that is being written.
pub(super) struct Writer {
    path: PathBuf,
    file: File,
    head: Head,
}

impl<'a> Folder<'a> {
    pub fn new(path: &'a Path, study: &'a Study) -> Self {
        Self { path, study }
    }

    /// Where the folder is.
    pub fn path(&self) -> &Path {
        self.path
    }

    /// Where the table of all rows goes.
    pub fn csv(&self) -> PathBuf {
        self.path.join(CSV)
    }

    /// Makes the folder where it is missing.
    pub fn make(&self) -> Result<(), Failure> {
        fs::create_dir_all(self.path).map_err(|error| named(self.path, &error))?;
        Ok(())
    }

    /// The logs that are there, by name; none without a folder.
    ///
    /// # Errors
    /// If one is of another study, or none at all.
    pub fn logs(&self) -> Result<Vec<Log>, Failure> {
        let entries = match fs::read_dir(self.path) {
            Ok(entries) => entries,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
            Err(error) => return Err(named(self.path, &error).into()),
        };
        let mut paths = Vec::new();
        for entry in entries {
            let entry = entry.map_err(|error| named(self.path, &error))?;
            let name = entry.file_name();
            let is_log = name
                .to_str()
                .is_some_and(|name| name.starts_with("results") && name.ends_with(".log"));
            if is_log {
                paths.push(entry.path());
            }
        }
        paths.sort();
        paths.iter().map(|path| self.read(path)).collect()
    }

    /// Opens a log for adding to it, and makes it where it is missing.
    ///
    /// # Errors
    /// If it cannot be written, or another process is at it.
    pub fn open(&self, name: &str, samples: Range<u64>) -> Result<Writer, Failure> {
        let path = self.path.join(name);
        let opened = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(&path);
        let file = opened.map_err(|error| named(&path, &error))?;
        // Where the system knows no locks, nobody is kept out.
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            let told = format!(
                "{} is being written by another sinew; wait for it, or name another folder with \
                 --out",
                origin(&path)
            );
            return Err(BadInput::Arguments(told).into());
        }
        let head = Head {
            digest: self.study.digest(),
            width: width(self.study),
            samples,
        };
        Ok(Writer { path, file, head })
    }

    /// Keeps the study and its scene beside the results.
    ///
    /// # Errors
    /// If they cannot be written, or a file of that name says something else.
    pub fn keep_study(&self) -> Result<(), Failure> {
        let file = StudyFile {
            scene: SCENE.to_owned(),
            ..self.study.file().clone()
        };
        let scene = self.study.scene().to_toml();
        let scene = scene.map_err(|error| Failure::Making(error.into()))?;
        self.keep(STUDY, &file.to_toml())?;
        self.keep(SCENE, &scene)
    }

    fn keep(&self, name: &str, text: &str) -> Result<(), Failure> {
        let path = self.path.join(name);
        match fs::read_to_string(&path) {
            Ok(there) if there == text => return Ok(()),
            Ok(_) => {
                let told = format!(
                    "{} is there already and is not of this study; name another folder with --out",
                    origin(&path)
                );
                return Err(BadInput::Arguments(told).into());
            }
            Err(_) => {}
        }
        let written = write_whole(&path, |file| Ok(file.write_all(text.as_bytes())?));
        // Another task of the same study may have been quicker.
        let is_there = || fs::read_to_string(&path).is_ok_and(|there| there == text);
        written.or_else(|failure| if is_there() { Ok(()) } else { Err(failure) })
    }

    /// Reads a log through.
    fn read(&self, path: &Path) -> Result<Log, Failure> {
        let named = |error| named(path, &error);
        let mut file = BufReader::new(File::open(path).map_err(named)?);
        let refused = |told: String| Failure::from(BadInput::Arguments(told));
        let width = width(self.study);
        let mut log = Log {
            path: path.to_owned(),
            width,
            chunks: Vec::new(),
            whole: 0,
        };
        let start = at_most(&mut file, HEAD_BYTES).map_err(named)?;
        match Head::of_bytes(&start) {
            Ok(head) if head.digest == self.study.digest() && head.width == width => {}
            Ok(_) => {
                return Err(refused(format!(
                    "{} has results of another study, scene or version of this program; they are \
                     as they were; name another folder with --out",
                    origin(path)
                )));
            }
            // Stopped at once.
            Err(HeadError::CutOff) => return Ok(log),
            Err(error) => {
                return Err(refused(format!(
                    "{}: {error}; it is as it was; name another folder with --out",
                    origin(path)
                )));
            }
        }
        let mut at = HEAD_BYTES as u64;
        log.whole = at;
        loop {
            let mut bytes = at_most(&mut file, CHUNK_HEAD_BYTES).map_err(named)?;
            let Some(length) = log::chunk_bytes(&bytes, width) else {
                return Ok(log);
            };
            let rest = length - bytes.len();
            bytes.extend(at_most(&mut file, rest).map_err(named)?);
            if bytes.len() < length {
                return Ok(log);
            }
            // One that is damaged is left out, and its samples are missing.
            if let Some((first, rows)) = log::rows(&bytes, width) {
                log.chunks.push(Chunk {
                    samples: first..first + rows.len() as u64,
                    at,
                    bytes: length,
                });
                log.whole = at + length as u64;
            }
            at += length as u64;
        }
    }
}

/// The samples that logs have.
pub(super) fn done(logs: &[Log]) -> Ranges {
    let mut done = Ranges::default();
    for chunk in logs.iter().flat_map(|log| &log.chunks) {
        done.add(chunk.samples.clone());
    }
    done
}

impl Log {
    /// The whole chunks, as they lie in the file.
    pub fn chunks(&self) -> &[Chunk] {
        &self.chunks
    }

    /// The rows of a chunk.
    ///
    /// # Errors
    /// If the file cannot be read, or has changed.
    pub fn rows(&self, chunk: &Chunk) -> Result<Vec<Row>, Failure> {
        let read = || -> io::Result<Vec<u8>> {
            let mut file = File::open(&self.path)?;
            file.seek(SeekFrom::Start(chunk.at))?;
            at_most(&mut file, chunk.bytes)
        };
        let bytes = read().map_err(|error| named(&self.path, &error))?;
        match log::rows(&bytes, self.width) {
            Some((_, rows)) => Ok(rows),
            None => {
                let told = io::Error::other("it was changed while it was read");
                Err(named(&self.path, &told).into())
            }
        }
    }
}

impl Writer {
    /// Makes the log, which is among these, one that ends with a whole chunk, and says what
    /// was cut off.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn mend(&mut self, logs: &[Log]) -> Result<Option<String>, Failure> {
        let own = logs.iter().find(|log| log.path == self.path);
        let whole = own.map_or(0, |log| log.whole);
        let mut mend = || -> io::Result<u64> {
            let bytes = self.file.metadata()?.len();
            self.file.set_len(whole)?;
            self.file.seek(SeekFrom::Start(whole))?;
            if whole == 0 {
                self.file.write_all(&self.head.to_bytes())?;
            }
            Ok(bytes - whole)
        };
        let cut = mend().map_err(|error| named(&self.path, &error))?;
        Ok((cut > 0).then(|| {
            format!(
                "{} ended within a chunk; its last {cut} bytes were cut off, and their samples \
                 are computed again",
                origin(&self.path)
            )
        }))
    }

    /// Adds a chunk.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn append(&mut self, first: u64, rows: &[Row]) -> Result<(), Failure> {
        let written = self.file.write_all(&log::chunk(first, rows));
        Ok(written.map_err(|error| self.kept(&error))?)
    }

    /// Waits until the system has it.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(&self) -> Result<(), Failure> {
        Ok(self.file.sync_all().map_err(|error| self.kept(&error))?)
    }

    /// The system's error, and what is to be done.
    fn kept(&self, error: &io::Error) -> io::Error {
        let error = named(&self.path, error);
        let told = format!("{error}; what was computed is kept, and --resume goes on");
        io::Error::new(error.kind(), told)
    }
}

fn width(study: &Study) -> u32 {
    // Outputs are a short list, none twice.
    study.computed().len() as u32
}

/// So many bytes, or those that there are.
fn at_most(file: &mut impl Read, count: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(count as u64).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Writes a file that is there whole or not at all.
///
/// # Errors
/// Those of `write`, and if the file cannot be made.
pub(super) fn write_whole<T>(
    path: &Path,
    write: impl FnOnce(&mut io::BufWriter<File>) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.part", process::id()));
    let part = path.with_file_name(name);
    let named = |error: io::Error| Failure::Output(named(path, &error));
    let file = File::create(&part).map_err(named)?;
    let mut file = io::BufWriter::new(file);
    let written = write(&mut file).and_then(|written| {
        let file = file.into_inner().map_err(|error| named(error.into()))?;
        file.sync_all().map_err(named)?;
        fs::rename(&part, path).map_err(named)?;
        Ok(written)
    });
    if written.is_err() {
        // A part of a file is of no use.
        let _ = fs::remove_file(&part);
    }
    written
}
