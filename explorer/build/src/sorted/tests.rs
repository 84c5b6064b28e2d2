use super::{Stream, sorted};

/// A module of two functions, which has an instruction of each kind of operands.
fn module() -> Vec<u8> {
    let first: &[u8] = &[
        1, 2, 0x7f, // two locals
        0x02, 0x40, 0x03, 0x40, 0x20, 0, 0x0d, 1, 0x0c, 0, 0x0b, 0x0b, // a loop in a block
        0x20, 0, 0x28, 2, 0x80, 1, 0x21, 1, 0x20, 0, 0x42, 0x7f, 0x37, 0, 8, // memory
        0x41, 0xff, 0xff, 0x03, 0x1a, 0x44, 1, 2, 3, 4, 5, 6, 7, 8, 0x1a, 0x43, 1, 2, 3, 4,
        0x1a, // constants
        0x20, 0, 0x0e, 1, 0, 0, // a table of branches
        0x41, 0, 0x41, 0, 0x41, 0, 0xfc, 10, 0, 0, 0x44, 0, 0, 0, 0, 0, 0, 0, 0, 0xfc, 2, 0x1a,
        0x10, 1, 0x41, 0, 0x11, 0, 0, 0x0b,
    ];
    let second = [&[0_u8][..], &[0x01; 200], &[0x0b]].concat();
    let mut code = vec![2, u8::try_from(first.len()).expect("a byte")];
    code.extend(first);
    code.extend([0xca, 0x01]);
    code.extend(second);
    let mut all = b"\0asm\x01\0\0\0".to_vec();
    all.extend([1, 4, 1, 0x60, 0, 0, 3, 3, 2, 0, 0, 10]);
    let size = code.len();
    all.extend([
        u8::try_from(size & 0x7f).expect("a byte") | 0x80,
        u8::try_from(size >> 7).expect("a byte"),
    ]);
    all.extend(code);
    all.extend([11, 1, 0]);
    all
}

#[test]
fn bytes_are_sorted_by_what_they_are() {
    let module = module();
    let all = sorted(&module).expect("a module");
    let (head, mut rest) = all.split_at(4 * Stream::COUNT);
    let mut streams = Vec::new();
    for length in head.chunks_exact(4) {
        let length = u32::from_le_bytes(length.try_into().expect("four bytes"));
        let (stream, after) = rest.split_at(length as usize);
        streams.push(stream);
        rest = after;
    }
    assert!(rest.is_empty());
    // All but the sizes of both functions, one of them of two bytes.
    assert_eq!(streams.iter().map(|stream| stream.len()).sum::<usize>(), module.len() - 3);
    let of = |stream: Stream| streams[stream as usize];
    assert_eq!(of(Stream::Branch), [1, 0, 1, 0, 0]);
    assert_eq!(of(Stream::Get), [0, 0, 0, 0]);
    assert_eq!(of(Stream::Set), [1]);
    // The load is aligned as it is by default, the store is not.
    assert_eq!(of(Stream::Align), [0, 3]);
    assert_eq!((of(Stream::Load), of(Stream::Store)), (&[0x80, 1][..], &[8][..]));
    assert_eq!(of(Stream::Int32), [0xff, 0xff, 0x03, 0, 0, 0, 0]);
    assert_eq!(of(Stream::Call), [1]);
    assert_eq!(of(Stream::Float).len(), 20);
}

#[test]
fn page_and_build_have_the_same_streams() {
    let page = include_str!("../../../page/restore.js");
    assert!(page.contains(&format!("const STREAMS = {};", Stream::COUNT)));
    let names = page.lines().find(|line| line.starts_with("const [OUTSIDE")).expect("names");
    for (name, stream) in
        [("OUTSIDE", Stream::Outside), ("INT32", Stream::Int32), ("OTHER", Stream::Other)]
    {
        let before = names.split(name).next().expect("a name").matches(',').count();
        assert_eq!(before, stream as usize, "{name}");
    }
}

#[test]
fn unknown_instructions_are_refused() {
    let module = module();
    assert_eq!(sorted(&module[..module.len() - 20]), None);
    let mut unknown = module;
    let place = unknown.len() - 100;
    unknown[place] = 0xff;
    assert_eq!(sorted(&unknown), None);
}
