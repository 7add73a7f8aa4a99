// A library that LD_PRELOAD puts before the C library: it lets one call of one kind fail, once, as the system would.
// tests/hostile/faults.py compiles it.
//
//     CYLON_FAULT=kind:n:place:log   kind is one of the names below.  The n-th call fails or, where place is not 0, the
//                                    first from the n-th on that comes from this place; `log` then gets "failed".
//     CYLON_FAULT=kind:0:0:log       None fails; `log` gets how many calls there were when main() has returned
//     CYLON_FAULT=kind:0:1:log       and a line for each place: the place, its calls, number of the first and of the last.
//
// Calls come from the same place where they have the same chain of callers.  A place is a hash of the return addresses,
// each relative to the module that it lies in, and so the same in every run of the same program.
//
// It counts from the start of main() on, and only in the process that it was loaded into: what that process forks has
// another id, and what it executes does not inherit the two variables.
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

enum Kind { allocation, process, channel, thread, writing, syncing, renaming, kinds };
constexpr const char* names[kinds] = {"malloc", "fork", "pipe", "thread", "write", "sync", "rename"};

Kind asked = kinds;
long at = 0;
std::uint64_t wanted_place = 0;
char log_file[4096];
pid_t owner = 0;
std::atomic<bool> counting = false;
std::atomic<long> calls = 0;

// Allocates nothing.
void tell(const char* text) {
  const long fd = ::syscall(SYS_openat, AT_FDCWD, log_file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  ::syscall(SYS_write, fd, text, std::strlen(text));
  ::syscall(SYS_close, fd);
}

constexpr int most_callers = 256;
__attribute__((tls_model("initial-exec"))) thread_local bool looking = false;  // backtrace() may allocate

// Of the call that is being made; 0 where this library made it itself.
std::uint64_t place_of_call() {
  if (looking) return 0;
  looking = true;
  std::array<void*, most_callers> callers;
  const int depth = ::backtrace(callers.data(), most_callers);
  std::uint64_t hash = 0;
  for (int i = 0; i < depth; ++i) {
    dl_find_object module;
    const auto address = reinterpret_cast<std::uintptr_t>(callers[i]);
    if (::_dl_find_object(callers[i], &module) != 0) continue;
    hash = (hash ^ (address - reinterpret_cast<std::uintptr_t>(module.dlfo_map_start))) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  looking = false;
  return std::max<std::uint64_t>(hash, 2);  // 0 and 1 have a meaning of their own
}

// Calls by place: a table with open addressing, which is larger than any program needs.
struct Place {
  std::atomic<std::uint64_t> hash;
  std::atomic<long> calls, first, last;
};
std::array<Place, 1 << 18> places;

void count_at(std::uint64_t hash, long number) {
  for (std::size_t i = hash % places.size(), tried = 0; tried < places.size();
       i = (i + 1) % places.size(), ++tried) {
    std::uint64_t taken = 0;
    if (!places[i].hash.compare_exchange_strong(taken, hash) && taken != hash) continue;
    if (++places[i].calls == 1) places[i].first = number;
    places[i].last = number;
    return;
  }
  tell("the table of places is full\n");
}

void tell_places() {
  for (const Place& place : places) {
    if (place.hash == 0) continue;
    std::array<char, 100> line;
    std::snprintf(line.data(), line.size(), "\n%016" PRIx64 " %ld %ld %ld", place.hash.load(),
                  place.calls.load(), place.first.load(), place.last.load());
    tell(line.data());
  }
}

// Whether this call is the one.
bool fails(Kind kind) {
  if (kind != asked || !counting.load(std::memory_order_relaxed) || looking) return false;
  const long number = ++calls;
  if (at == 0 ? wanted_place == 0 : number < at) return false;
  if (wanted_place == 0 && number != at) return false;
  if (wanted_place != 0) {
    const std::uint64_t place = place_of_call();
    if (at == 0) count_at(place, number);
    if (at == 0 || place != wanted_place) return false;
  }
  if (::syscall(SYS_getpid) != owner || !counting.exchange(false)) return false;
  tell("failed");
  return true;
}

// The function that this library stands before.
template <class Function>
Function* next(const char* name, Function*) {
  void* found = ::dlsym(RTLD_NEXT, name);
  Function* function = nullptr;
  std::memcpy(&function, &found, sizeof function);
  return function;
}
#define NEXT(name) static auto* const real = next(#name, &::name)

// A file's disk is full; the other end of a pipe or socket is gone.
int error_of_writing(int fd) {
  struct stat status = {};
  return ::fstat(fd, &status) == 0 && S_ISREG(status.st_mode) ? ENOSPC : EIO;
}

int (*real_main)(int, char**, char**);

int counted_main(int argc, char** argv, char** environment) {
  counting = asked != kinds;
  const int code = real_main(argc, argv, environment);
  counting = false;
  char text[32];
  std::snprintf(text, sizeof text, "%ld", calls.load());
  if (asked != kinds && at == 0) tell(text), tell_places();
  return code;
}

__attribute__((constructor)) void configure() {
  const char* text = std::getenv("CYLON_FAULT");
  char kind[16] = "";
  if (text && std::sscanf(text, "%15[^:]:%ld:%" SCNx64 ":%4095s", kind, &at, &wanted_place, log_file) == 4)
    for (int i = 0; i < kinds; ++i)
      if (std::strcmp(kind, names[i]) == 0) asked = static_cast<Kind>(i);
  void* first = nullptr;
  ::backtrace(&first, 1);  // loads what it needs
  owner = ::getpid();
  ::unsetenv("CYLON_FAULT");
  ::unsetenv("LD_PRELOAD");
}

}  // namespace

#define FAIL(kind, error, value) \
  if (fails(kind)) {             \
    errno = error;               \
    return value;                \
  }

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*rtld_fini)(), void* stack_end) {
  using Start = int(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
  real_main = main;
  return next("__libc_start_main", static_cast<Start*>(nullptr))(counted_main, argc, argv, init, fini,
                                                                 rtld_fini, stack_end);
}

void* malloc(std::size_t size) {
  FAIL(allocation, ENOMEM, nullptr)
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  FAIL(allocation, ENOMEM, nullptr)
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  FAIL(allocation, ENOMEM, nullptr)
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  FAIL(allocation, ENOMEM, nullptr)
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  if (fails(allocation)) return ENOMEM;
  *out = __libc_memalign(alignment, size);
  return *out ? 0 : ENOMEM;
}

pid_t fork() {
  FAIL(process, EAGAIN, -1)
  NEXT(fork);
  return real();
}
// As harness/process/spawn.cc calls it, without further arguments.
int clone(int (*work)(void*), void* stack, int flags, void* argument, ...) {
  FAIL(process, EAGAIN, -1)
  NEXT(clone);
  return real(work, stack, flags, argument);
}
int posix_spawn(pid_t* pid, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const argv[], char* const environment[]) {
  if (fails(process)) return EAGAIN;
  NEXT(posix_spawn);
  return real(pid, path, actions, attributes, argv, environment);
}
// The C library starts the shell by calls of its own.
int system(const char* line) {
  FAIL(process, EAGAIN, -1)
  NEXT(system);
  return real(line);
}

int pipe(int ends[2]) {
  FAIL(channel, EMFILE, -1)
  NEXT(pipe);
  return real(ends);
}
int pipe2(int ends[2], int flags) {
  FAIL(channel, EMFILE, -1)
  NEXT(pipe2);
  return real(ends, flags);
}
int socketpair(int domain, int type, int protocol, int ends[2]) {
  FAIL(channel, EMFILE, -1)
  NEXT(socketpair);
  return real(domain, type, protocol, ends);
}

int pthread_create(pthread_t* made, const pthread_attr_t* attributes, void* (*work)(void*), void* argument) {
  if (fails(thread)) return EAGAIN;
  NEXT(pthread_create);
  return real(made, attributes, work, argument);
}

ssize_t write(int fd, const void* bytes, std::size_t size) {
  FAIL(writing, error_of_writing(fd), -1)
  NEXT(write);
  return real(fd, bytes, size);
}
ssize_t writev(int fd, const iovec* pieces, int count) {
  FAIL(writing, error_of_writing(fd), -1)
  NEXT(writev);
  return real(fd, pieces, count);
}
ssize_t pwrite64(int fd, const void* bytes, std::size_t size, off64_t from) {
  FAIL(writing, error_of_writing(fd), -1)
  NEXT(pwrite64);
  return real(fd, bytes, size, from);
}
ssize_t pwrite(int fd, const void* bytes, std::size_t size, off_t from) {
  FAIL(writing, error_of_writing(fd), -1)
  NEXT(pwrite);
  return real(fd, bytes, size, from);
}
// std::cout writes by these.
std::size_t fwrite(const void* bytes, std::size_t size, std::size_t count, FILE* file) {
  FAIL(writing, ENOSPC, 0)
  NEXT(fwrite);
  return real(bytes, size, count, file);
}
int fflush(FILE* file) {
  FAIL(writing, ENOSPC, EOF)
  NEXT(fflush);
  return real(file);
}

int fsync(int fd) {
  FAIL(syncing, EIO, -1)
  NEXT(fsync);
  return real(fd);
}
int fdatasync(int fd) {
  FAIL(syncing, EIO, -1)
  NEXT(fdatasync);
  return real(fd);
}

int rename(const char* from, const char* to) {
  FAIL(renaming, ENOSPC, -1)
  NEXT(rename);
  return real(from, to);
}

}  // extern "C"
