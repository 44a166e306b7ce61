// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <oracle/subjects/subject.h>
#include <oracle/subjects/subject_protocol.h>

namespace lightcuts::oracle {

/// Who answers a tree's questions to a plug-in. Nothing of an answer is believed.
class PluginConnection {
public:
  virtual ~PluginConnection() = default;
  /// The answer to a request, of `most` bytes at most; valid until the next. about: what else is to
  /// be said of the question where it is not answered. Throws SubjectFailure.
  [[nodiscard]] virtual std::span<const std::byte> ask(protocol::Request request,
                                                       std::span<const std::byte> payload,
                                                       std::uint64_t most,
                                                       std::string about = {}) = 0;
  /// Ends the connection for what was answered, which cannot be read.
  [[noreturn]] void refuse(const std::string& what) { throw SubjectFailure(ended(what)); }
  [[nodiscard]] virtual bool is_alive() const = 0;

protected:
  /// Ends the connection; returns what is to be said of it.
  virtual std::string ended(const std::string& what) = 0;
};

/// Connections to one plug-in, each for one tree at a time. Used by many threads.
class PluginConnections {
public:
  virtual ~PluginConnections() = default;
  [[nodiscard]] virtual std::unique_ptr<PluginConnection> take() = 0;
  virtual void give_back(std::unique_ptr<PluginConnection> connection) = 0;
};

} // namespace lightcuts::oracle
