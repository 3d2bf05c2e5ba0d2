// tools/run/documents.cpp: reads the documents of the input, and adds their places to what is wrong with them.
#include "run/documents.h"

#include <cerrno>
#include <new>
#include <system_error>

#include "formats/document/document_reader.h"
#include "formats/document/document_stream.h"
#include "formats/document/mesh_document.h"
#include "formats/msh/msh.h"
#include "pliant/mesh/documents/document_unit.h"
#include "run/doubts.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

/// Runs `work`, and adds to what it throws which document it is about: `describe` puts the place of a fault before its
/// text, and `opening` stands before every other text.
void with_source(const std::string& opening,
                 const std::function<std::string(const std::string& pointer, const std::string& text)>& describe,
                 const std::function<void()>& work) {
  try {
    work();
  } catch (const BadMesh& e) {
    std::string text;
    for (const Fault& fault : e.faults()) text += (text.empty() ? "" : "\n") + describe(fault.place, fault.text);
    throw Placed(status::bad_input, text);
  } catch (const InputError& e) {
    throw Placed(status::bad_input, describe(e.pointer(), e.what()));
  } catch (const Placed&) {
    throw;
  } catch (const UsageError&) {
    throw;
  } catch (const std::system_error&) {
    throw;
  } catch (const NoResult& e) {
    throw Placed(status::no_result, opening + e.what());
  } catch (const std::domain_error& e) {
    throw Placed(status::no_result, opening + e.what());
  } catch (const std::bad_alloc&) {
    throw Placed(status::no_result, opening + std::string(out_of_memory));
  } catch (const std::length_error&) {  // of a container that would be larger than the address space
    throw Placed(status::no_result, opening + std::string(out_of_memory));
  } catch (const std::exception& e) {
    throw Placed(status::internal_error, opening + describe_internal_error(e.what()));
  }
}

/// The same with the place in the document.
void with_place(const InputDocument& document, const std::function<void()>& work) {
  const Frame& frame = document.frame();
  with_source(
      frame.source + ": frame " + std::to_string(frame.index) + ": ",
      [&](const std::string& pointer, const std::string& text) { return describe_fault(document, pointer, text); },
      [&] {
        try {
          work();
        } catch (const DocumentError& e) {
          throw Placed(status::bad_input, describe_at(frame, e.place(), e.pointer(), e.text()));
        }
      });
}

/// Says which triangles are which elements, in a few lines or not at all.
void say_numbers(const ToolOptions& options, const Frame& frame, const TagRuns& elements) {
  const std::vector<TagRuns::Run>& runs = elements.runs();
  constexpr std::size_t most = 20;
  for (std::size_t k = 0; k < runs.size() && runs.size() <= most; ++k) {
    const std::size_t end = k + 1 < runs.size() ? runs[k + 1].first : elements.size();
    say(options, frame.source + ": triangles " + std::to_string(runs[k].first) + " to " + std::to_string(end - 1) +
                     " are elements " + std::to_string(runs[k].tag) + " to " +
                     std::to_string(runs[k].tag + (end - 1 - runs[k].first)));
  }
}

void use_msh(const ToolOptions& options, const MshOptions& msh, std::string_view bytes, const Frame& frame,
             const std::function<void(MshImport&&, const Frame&)>& use) {
  const std::string opening = frame.source + ": ";
  with_source(
      opening, [&](const std::string& pointer, const std::string& text) { return opening + at_pointer(pointer, text); },
      [&] {
        MshImport import = read_msh(bytes, msh);
        for (const std::string& text : import.warnings) say(options, opening + text);
        if (options.verbose) say_numbers(options, frame, import.elements);
        use(std::move(import), frame);
      });
}

/// for_each_document but for DocumentTooLong, which comes out as it is.
void read_documents(const ToolOptions& options, FileKind kind, const std::function<bool(InputDocument&)>& use,
                    const std::function<void(std::string_view bytes, const Frame&)>& use_msh_file) {
  Frame frame;
  frame.source = options.input == "-" ? "standard input" : options.input;
  const InputFile file = open_input(options.input);
  DocumentStream stream(file.get(), frame.source);
  if (use_msh_file) {
    const std::string_view bytes = stream.all_if("$");
    if (!bytes.empty()) return use_msh_file(bytes, frame);
  }
  std::string head(stream.head_unless_object(recognized_by));
  std::string_view text;
  while (stream.next(text)) {
    frame.index = stream.frame();
    frame.line = stream.first_line();
    frame.byte = stream.first_byte();
    frame.form = form_of(text);
    if (head.empty()) head = text.substr(0, recognized_by);
    InputDocument document(text, frame, [&stream] { stream.release(); });
    bool goes_on = true;
    try {
      with_place(document, [&] { goes_on = use(document); });
    } catch (const Placed& e) {
      const std::string other =
          e.status() == status::bad_input && frame.index == 0 ? describe_other_kind(head, kind) : "";
      if (other.empty()) throw;
      throw Placed(status::bad_input, frame.source + ": " + other);
    }
    if (!goes_on) return;
  }
  if (stream.frame() < 0)
    throw Placed(status::bad_input,
                 frame.source + ":1: the input is empty" + (options.input == "-" ? "" : "; expected a document"));
}

/// What works on a mesh of the input, and returns whether the next one is to be read. `forget_text` as in
/// for_each_mesh.
using MeshUse = std::function<bool(MeshData&&, const Frame&, const std::function<void()>& forget_text)>;

void read_meshes(const ToolOptions& options, const MeshUse& use) {
  Doubts doubts(options);
  const auto use_document = [&](InputDocument& document) {
    ReaderNotes notes;
    MeshData data = read_mesh(document.text(), &notes);
    doubts.say_new(document, std::move(notes.doubts));
    document.release_if_exact(notes.arrays);
    require_document_size(data);
    return use(std::move(data), document.frame(), [&] { document.release(notes.arrays); });
  };
  for_each_document(options, FileKind::mesh, use_document, [&](std::string_view bytes, const Frame& frame) {
    use_msh(options, {}, bytes, frame, [&](MshImport&& import, const Frame&) {
      require_document_size(import.mesh);
      if (options.verbose)
        for (const std::string& text : import.notes) say(options, frame.source + ": " + text);
      MeshData mesh = std::move(import.mesh);
      try {
        use(std::move(mesh), frame, [] {});
      } catch (const BadMesh& e) {
        std::vector<Fault> faults;
        for (const Fault& fault : e.faults()) faults.push_back(in_msh_words(import, fault));
        throw BadMesh(std::move(faults));
      }
    });
  });
}

}  // namespace

void InputCloser::operator()(std::FILE* file) const {
  if (file != stdin) std::fclose(file);
}

InputFile open_input(const std::string& path) {
  InputFile file(path == "-" ? stdin : std::fopen(path.c_str(), "rb"));
  if (file == nullptr) throw std::system_error(errno, std::generic_category(), path);
  return file;
}

std::string describe_internal_error(const std::string& text) {
  return "internal error: " + text + "; please report it, with the command and its input";
}

void for_each_document(const ToolOptions& options, FileKind kind, const std::function<bool(InputDocument&)>& use,
                       const std::function<void(std::string_view bytes, const Frame&)>& use_msh_file) {
  try {
    read_documents(options, kind, use, use_msh_file);
  } catch (const DocumentTooLong& e) {
    throw Placed(status::no_result, e.what());
  }
}

void for_each_mesh(const ToolOptions& options,
                   const std::function<void(MeshData&&, const Frame&, const std::function<void()>&)>& use) {
  read_meshes(options, [&use](MeshData&& mesh, const Frame& frame, const std::function<void()>& forget_text) {
    use(std::move(mesh), frame, forget_text);
    return true;
  });
}

void for_each_mesh(const ToolOptions& options, const std::function<void(MeshData&&, const Frame&)>& use) {
  read_meshes(options, [&use](MeshData&& mesh, const Frame& frame, const std::function<void()>&) {
    use(std::move(mesh), frame);
    return true;
  });
}

void find_mesh(const ToolOptions& options, const std::function<bool(MeshData&&, const Frame&)>& take) {
  read_meshes(options, [&take](MeshData&& mesh, const Frame& frame, const std::function<void()>&) {
    return !take(std::move(mesh), frame);
  });
}

void for_msh(const ToolOptions& options, const MshOptions& msh,
             const std::function<void(MshImport&&, const Frame&)>& use) {
  // What is no MSH file goes to its reader all the same, which says so.
  const auto read = [&](std::string_view bytes, const Frame& frame) { use_msh(options, msh, bytes, frame, use); };
  const auto read_document = [&](const InputDocument& document) {
    read(document.text(), document.frame());
    return true;
  };
  for_each_document(options, FileKind::msh, read_document, read);
}

void for_each_boundary(const ToolOptions& options, const std::function<void(BoundaryComplex&&, const Frame&)>& use) {
  Doubts doubts(options);
  for_each_document(options, FileKind::boundary, [&](const InputDocument& document) {
    ReaderNotes notes;
    BoundaryComplex boundary = read_boundary(document.text(), &notes);
    doubts.say_new(document, std::move(notes.doubts));
    use(std::move(boundary), document.frame());
    return true;
  });
}

}  // namespace pliant
