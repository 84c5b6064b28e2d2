//! One row a scenario, as Parquet: the same rows are the same bytes.
//!
//! Columns are `index` (unsigned) and the doubles of [`Campaign::columns`]; the text of the campaign
//! stands in the metadata, so that parts of different campaigns are told apart, with the version that
//! wrote it and a checksum of all bytes.

mod seal;

use std::fs::{self, File};
use std::io::{Read, Seek, Write};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::column::writer::ColumnWriter;
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{PrimitiveTypeBuilder, Type};

pub use seal::hash;

use super::{Campaign, ENGINE};

/// One scenario and what it gave.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Index of the scenario.
    pub index: u64,
    /// The columns of [`Campaign::columns`].
    pub numbers: Vec<f64>,
}

/// Rows that are written together: they are what a file takes of memory.
const GROUP: usize = 1 << 16;

/// The key of the campaign's text.
const CAMPAIGN: &str = "ptc.campaign";

/// The key of the hash of that text.
const DESIGN: &str = "ptc.design";

/// The key of the version of this crate, on which the rows depend.
const VERSION: &str = "ptc.version";

/// Name of the program that writes.
pub const PROGRAM: &str = "ptc-codegen verify";

/// A file of rows under way.
pub struct Writer<W: Read + Write + Seek + Send> {
    file: SerializedFileWriter<W>,
    rows: Vec<Row>,
    columns: usize,
}

impl<W: Read + Write + Seek + Send> Writer<W> {
    /// Begins a file.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn new(to: W, campaign: &Campaign) -> Result<Self> {
        let columns = campaign.columns();
        let text = campaign.text();
        let pair = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
        let pairs = vec![
            pair(VERSION, ENGINE.to_owned()),
            pair(DESIGN, hash(text.as_bytes())),
            pair(CAMPAIGN, text),
            pair(seal::KEY, seal::OPEN.to_owned()),
        ];
        let properties = WriterProperties::builder()
            .set_created_by(PROGRAM.to_owned())
            .set_key_value_metadata(Some(pairs))
            .set_dictionary_enabled(false)
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .build();
        let unsigned = LogicalType::integer(64, false);
        let index = required("index", Physical::INT64).with_logical_type(Some(unsigned)).build()?;
        let mut fields = vec![Arc::new(index)];
        for name in &columns {
            fields.push(Arc::new(required(name, Physical::DOUBLE).build()?));
        }
        let schema = Type::group_type_builder("scenario").with_fields(fields).build()?;
        let file = SerializedFileWriter::new(to, Arc::new(schema), Arc::new(properties))?;
        Ok(Self { file, rows: Vec::new(), columns: columns.len() })
    }

    /// Adds a row.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn push(&mut self, row: Row) -> Result<()> {
        self.rows.push(row);
        if self.rows.len() == GROUP { self.group() } else { Ok(()) }
    }

    /// Ends the file.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn finish(mut self) -> Result<W> {
        if !self.rows.is_empty() {
            self.group()?;
        }
        let mut file = self.file.into_inner()?;
        seal::close(&mut file)?;
        Ok(file)
    }

    fn group(&mut self) -> Result<()> {
        let rows = std::mem::take(&mut self.rows);
        let mut group = self.file.next_row_group()?;
        let mut place = 0;
        while let Some(mut column) = group.next_column()? {
            match column.untyped() {
                ColumnWriter::Int64ColumnWriter(writer) => {
                    let index: Vec<_> = rows.iter().map(|row| row.index.cast_signed()).collect();
                    writer.write_batch(&index, None, None)?;
                }
                ColumnWriter::DoubleColumnWriter(writer) if place < self.columns => {
                    let numbers: Vec<_> = rows.iter().map(|row| row.numbers[place]).collect();
                    writer.write_batch(&numbers, None, None)?;
                    place += 1;
                }
                _ => return Err(ParquetError::General("a column of another type".to_owned())),
            }
            column.close()?;
        }
        group.close()?;
        Ok(())
    }
}

fn required(name: &str, physical: Physical) -> PrimitiveTypeBuilder<'_> {
    Type::primitive_type_builder(name, physical).with_repetition(Repetition::REQUIRED)
}

/// The indices that a file holds; the file is one of `campaign`.
///
/// # Errors
/// It cannot be read, is no such file, or is damaged.
pub fn extent(path: &Path, campaign: &Campaign) -> Result<Range<u64>> {
    let file = open(path, campaign)?;
    if file.num_row_groups() == 0 {
        return Ok(0..0);
    }
    let mut first = Vec::new();
    if let ColumnReader::Int64ColumnReader(mut reader) =
        file.get_row_group(0)?.get_column_reader(0)?
    {
        reader.read_records(1, None, None, &mut first)?;
    }
    let start = first.first().copied().unwrap_or(0).cast_unsigned();
    let count = file.metadata().file_metadata().num_rows().cast_unsigned();
    Ok(start..start.saturating_add(count))
}

fn open(path: &Path, campaign: &Campaign) -> Result<SerializedFileReader<File>> {
    let wrong = |what: String| Err(ParquetError::General(what));
    if !fs::metadata(path)?.is_file() {
        return wrong("it is not a regular file".to_owned());
    }
    let mut file = File::open(path)?;
    if !seal::holds(&mut file)? {
        return wrong("not a file of `verify`, or damaged since: its checksum is wrong".to_owned());
    }
    let file = SerializedFileReader::new(file)?;
    let pairs = file.metadata().file_metadata().key_value_metadata();
    let pairs = pairs.map(Vec::as_slice).unwrap_or_default();
    let value = |key: &str| {
        let pair = pairs.iter().find(|pair| pair.key == key);
        pair.and_then(|pair| pair.value.as_deref()).unwrap_or_default()
    };
    if value(VERSION) != ENGINE {
        let there = value(VERSION);
        return wrong(format!("it is of version {there} of ptc-codegen, and this is {ENGINE}"));
    }
    if value(CAMPAIGN) != campaign.text() {
        let differing = differing(value(CAMPAIGN), &campaign.text());
        return wrong(format!("it is of another campaign: {differing}"));
    }
    Ok(file)
}

/// Hands over the rows of a file in their order; the file is one of `campaign`.
///
/// # Errors
/// It cannot be read, is no such file, is damaged, or what `visit` says.
pub fn read(
    path: &Path,
    campaign: &Campaign,
    visit: &mut dyn FnMut(Row) -> Result<()>,
) -> Result<()> {
    let file = open(path, campaign)?;
    let columns = campaign.columns().len();
    for group in 0..file.num_row_groups() {
        let group = file.get_row_group(group)?;
        let count = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
        let mut rows = Vec::with_capacity(count);
        for column in 0..=columns {
            match group.get_column_reader(column)? {
                ColumnReader::Int64ColumnReader(mut reader) if column == 0 => {
                    let mut index = Vec::with_capacity(count);
                    reader.read_records(count, None, None, &mut index)?;
                    rows.extend(index.iter().map(|index| Row {
                        index: index.cast_unsigned(),
                        numbers: Vec::with_capacity(columns),
                    }));
                }
                ColumnReader::DoubleColumnReader(mut reader) if column > 0 => {
                    let mut numbers = Vec::with_capacity(count);
                    reader.read_records(count, None, None, &mut numbers)?;
                    rows.iter_mut().zip(numbers).for_each(|(row, number)| row.numbers.push(number));
                }
                _ => return Err(ParquetError::General("a column has another type".to_owned())),
            }
        }
        if rows.iter().any(|row| row.numbers.len() != columns) {
            return Err(ParquetError::General("a column is too short".to_owned()));
        }
        rows.into_iter().try_for_each(&mut *visit)?;
    }
    Ok(())
}

/// The first line in which two texts of campaigns differ.
pub fn differing(there: &str, here: &str) -> String {
    let mut lines = there.lines().zip(here.lines());
    match lines.find(|(there, here)| there != here) {
        Some((there, here)) => format!("`{there}` there, `{here}` here"),
        None => "one has more to it than the other".to_owned(),
    }
}
