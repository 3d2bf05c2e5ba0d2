// tools/stages/measure.h: the stage that passes meshes on as they are, and writes what it measures of them to tables.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "measure/columns.h"
#include "measure/table_file.h"
#include "stages/stage.h"

namespace pliant {

class MeasureStage : public Stage {
 public:
  const char* name() const override { return "measure"; }
  const char* description() const override {
    return "Measure places, lines, faces and curves of meshes, write it as CSV, and pass the meshes on as they are.";
  }
  bool explains() const override { return wants_explanation_ || csv_ == "-" || lines_csv_ == "-"; }
  const char* explaining_option() const override {
    return wants_explanation_ ? "--explain" : csv_ == "-" ? "--csv -" : "--lines-csv -";
  }
  void add_options(CLI::App& app) override;
  void check(const CLI::App& app) override;
  std::string explanation(Mesh& mesh) const override;
  PassReport run(Mesh& mesh, const StageContext& context) const override;

 private:
  void read_requests();
  void check_files(const CLI::App& app);

  std::string csv_, lines_csv_, outside_ = "empty";
  std::vector<std::string> points_, lines_, faces_, curves_, values_, set_;
  bool wants_explanation_ = false;
  MeasureRequests requests_;
  std::unique_ptr<TableFile> table_, lines_table_;  ///< null where they go to standard output, or nowhere
  mutable std::string printed_header_;              ///< of what went to standard output last
};

}  // namespace pliant
