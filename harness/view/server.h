// The viewer's server: HTTP on 127.0.0.1 alone, for the page that it gives out and nobody else.
#pragma once

#include "harness/view/frames.h"
#include "harness/view/host.h"

#include <memory>
#include <optional>
#include <string>

namespace cylon::view {

/// Serves GET / and /api/session, /api/stream, POST /api/command, /api/frame
/// (reports/web/src/shared/live.ts).
///
/// Every request must name 127.0.0.1 or localhost with the port as its Host, so that no name that somebody
/// else made to point here will do; an Origin, where there is one, must be the same; and every request under
/// /api must bring the token: 128 random bits that no answer holds, the page neither.  The user gets them in address(),
/// behind the '#', which a browser keeps to itself and gives to the page's script.  All this is asked before the body is read.  Bodies state their length, 64 KiB at most (a frame: 32 MiB); heads have at most 16 KiB and
/// 100 headers.  A head has 3 s, a body 20 s.  32 connections are served at once, at most four of them
/// streams; one more takes the place of the oldest that has not finished asking.  No folder is served.
class Server {
 public:
  /// Listens on `port`, 0: any that is free.  Throws core::InputError where the port is taken.  `frames`:
  /// null where none are kept.  Both must outlive the server.
  Server(Host&, Frames* frames, int port);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  int port() const;
  const std::string& token() const;
  std::string url() const;
  /// The url with the token: for the user alone, so on no command line and in no file that others can read.
  std::string address() const;

  /// Closes the door and ends all connections; the host must have been stopped, or streams would go on.
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cylon::view
