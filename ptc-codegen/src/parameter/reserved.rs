//! Words that cannot name a controller.

/// Keywords of C, C++ and Rust, and the names that all controllers share.
const RESERVED: &str = "
    abstract alignas alignof and as asm async auto await become bool box break case catch char
    class compl const constexpr continue crate default delete do double dyn else enum explicit
    export extern false final float fn for friend gen goto if impl in inline int let long loop
    macro main match mod move mut mutable namespace new not nullptr operator or override priv
    private protected ptc ptc_status pub public ref register restrict return self Self short
    signed sizeof static struct super switch template this throw trait true try type typedef
    typeid typename typeof union unsafe unsigned unsized use using virtual void volatile where
    while xor yield
";

/// Macros of C's `stddef.h` and `math.h`, and of gcc's default dialect.
const DECLARED: &str = "NULL NAN INFINITY HUGE_VAL linux math_errhandling unix";

/// Prefix of the constants of `math.h`.
const CONSTANT: &str = "M_";

/// Functions that headers of C and POSIX other than `math.h` declare.
const LIBRARY: &str = "
    a64l abort abs accept access acct adjtime alarm alloca arc4random asctime atexit atof
    atoi atol atoll bcmp bcopy bind brk bsearch bzero calloc chdir chmod chown chroot
    clearenv clearerr clock close closefrom confstr connect creat crypt ctermid ctime daemon
    difftime div dprintf drand48 dup dup2 duplocale dysize ecvt endusershell erand48 execl
    execle execlp execv execve execvp exit faccessat fchdir fchmod fchmodat fchown fchownat
    fclose fcntl fcvt fdatasync fdopen feof ferror fexecve fflush ffs ffsl ffsll fgetc
    fgetpos fgets fileno flockfile fmemopen fopen fork fpathconf fprintf fputc fputs fread
    free freelocale freopen fscanf fseek fseeko fsetpos fstat fstatat fsync ftell ftello
    ftruncate ftrylockfile funlockfile futimens futimes fwrite gcvt getc getchar getcwd
    getdelim getdomainname getdtablesize getegid getentropy getenv geteuid getgid getgroups
    gethostid gethostname getitimer getline getloadavg getlogin getopt getpagesize getpass
    getpeername getpgid getpgrp getpid getppid getsid getsockname getsockopt getsubopt
    gettimeofday getuid getusershell getw getwd gmtime gsignal imaxabs imaxdiv index
    initstate isalnum isalpha isascii isatty isblank iscntrl isdigit isfdtype isgraph
    islower isprint ispunct isspace isupper isxdigit jrand48 kill killpg l64a labs lchmod
    lchown lcong48 ldiv link linkat listen llabs lldiv localeconv localtime lockf longjmp
    lrand48 lseek lstat lutimes malloc mblen mbstowcs mbtowc memccpy memchr memcmp memcpy
    memmove memset mkdir mkdirat mkdtemp mkfifo mkfifoat mknod mknodat mkstemp mkstemps
    mktemp mktime mrand48 nanosleep newlocale nice nrand48 open openat pathconf pause pclose
    perror pipe poll popen pread printf profil pselect psiginfo psignal putc putchar putenv
    puts putw pwrite qecvt qfcvt qgcvt qsort raise rand random read readlink readlinkat
    realloc reallocarray realpath recv recvfrom recvmsg remove rename renameat revoke rewind
    rindex rmdir rpmatch sbrk scanf seed48 select send sendmsg sendto setbuf setbuffer
    setdomainname setegid setenv seteuid setgid sethostid sethostname setitimer setjmp
    setlinebuf setlocale setlogin setpgid setpgrp setregid setreuid setsid setsockopt
    setstate settimeofday setuid setusershell setvbuf shutdown sigaction sigaddset
    sigaltstack sigblock sigdelset sigemptyset sigfillset siggetmask siginterrupt
    sigismember siglongjmp signal sigpending sigprocmask sigqueue sigreturn sigsetmask
    sigstack sigsuspend sigtimedwait sigwait sigwaitinfo sleep snprintf sockatmark socket
    socketpair sprintf srand srand48 srandom sscanf ssignal stat stpcpy stpncpy strcasecmp
    strcat strchr strcmp strcoll strcpy strcspn strdup strerror strftime strlen strncasecmp
    strncat strncmp strncpy strndup strnlen strpbrk strrchr strsep strsignal strspn strstr
    strtod strtof strtoimax strtok strtol strtold strtoll strtoq strtoul strtoull strtoumax
    strtouq strxfrm symlink symlinkat sync syscall sysconf system tcgetpgrp tcsetpgrp
    tempnam time timegm timelocal tmpfile tmpnam toascii tolower toupper truncate ttyname
    ttyslot tzset ualarm umask ungetc unlink unlinkat unsetenv uselocale usleep utimensat
    utimes valloc vdprintf vfork vfprintf vfscanf vhangup vprintf vscanf vsnprintf vsprintf
    vsscanf wait wait3 wait4 waitid waitpid wcstoimax wcstombs wcstoumax wctomb write
";

/// Functions of C's `math.h`, each of which also exists with the suffixes `f` and `l`.
const FUNCTIONS: &str = "
    acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh drem erf erfc exp exp10 exp2
    expm1 fabs fdim finite floor fma fmax fmin fmod frexp gamma hypot ilogb isfinite isinf isnan j0 j1 jn
    ldexp lgamma llrint llround log log10 log1p log2 logb lrint lround modf nan nearbyint nextafter
    nexttoward pow pow10 remainder remquo rint round scalb scalbln scalbn signbit significand sin
    sincos sinh sqrt tan tanh tgamma trunc y0 y1 yn
";

/// Headers of C and modules of Python, for which a controller's own files would be taken.
const FILES: &str = "
    assert complex ctype dataclasses errno fenv inttypes iso646 limits locale math numpy ptc setjmp
    signal stdarg stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time
    typing uchar wchar wctype
";

/// Prefix of all statuses.
const STATUS: &str = "PTC_";

/// Types beside the controller's own in an emitted Rust file, and a trait it uses.
const TYPES: [&str; 6] = ["Control", "Controller", "Error", "FnOnce", "Result", "Status"];

/// Returns true if `word` is a keyword, or a name that C's headers declare as a macro.
pub(super) fn is_word(word: &str) -> bool {
    RESERVED.split_whitespace().any(|one| one == word)
        || word.starts_with(STATUS)
        || word.starts_with(CONSTANT)
        || DECLARED.split_whitespace().any(|one| one == word)
}

/// Returns true if `word` cannot name a controller.
pub(crate) fn is_reserved(word: &str) -> bool {
    reason(word).is_some()
}

/// Why `word`, an identifier, cannot name a controller; `None` if it can.
pub(crate) fn reason(word: &str) -> Option<&'static str> {
    let among = |words: &str, word: &str| words.split_whitespace().any(|one| one == word);
    let stem = word.strip_suffix(['f', 'l']).unwrap_or(word);
    let reasons = [
        (word.starts_with('_'), "C reserves names that begin with an underscore"),
        (word.ends_with("_t"), "POSIX reserves names that end in _t"),
        (is_word(word), "it is a word of C, C++ or Rust, or what all controllers share"),
        (among(FUNCTIONS, word) || among(FUNCTIONS, stem), "it is a function of C's math.h"),
        (among(LIBRARY, word), "it is a function of C's library"),
        (among(FILES, word), "its files would take the place of a header or module of that name"),
        (
            TYPES.contains(&super::type_name(word).as_str()),
            "its type would have the name of another one in Rust",
        ),
    ];
    reasons.into_iter().find(|(applies, _)| *applies).map(|(_, reason)| reason)
}

#[cfg(test)]
mod tests {
    use super::is_reserved;

    #[test]
    fn names_that_would_not_compile_are_reserved() {
        for word in [
            "int",
            "fn",
            "_x",
            "__",
            "exp",
            "expf",
            "sqrtl",
            "size_t",
            "status",
            "Error",
            "fn_once",
            "self",
            "stdint",
            "math",
            "PTC_STATUS_DEFINED",
            "PTC_OK",
            "M_PI",
            "linux",
            "unix",
            "index",
            "div",
            "abs",
            "read",
        ] {
            assert!(is_reserved(word), "{word}");
        }
        for word in [
            "roll", "ptc_exp3", "stage", "x_f", "Roll2", "state", "shelf", "level", "x1", "t",
            "inv_T", "gains",
        ] {
            assert!(!is_reserved(word), "{word}");
        }
    }
}
