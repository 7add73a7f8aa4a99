// A plugin of clang-tidy 14: the checks walk over our declarations alone.  Findings in the headers of
// libraries are never shown, and yet the walk over them is five sixths of the time.  tests/lint.py builds and
// loads it.
#include <clang/AST/ASTConsumer.h>
#include <clang/AST/ASTContext.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Frontend/FrontendPluginRegistry.h>

#include <memory>
#include <string>
#include <vector>

namespace {

class Scope final : public clang::ASTConsumer {
 public:
  void HandleTranslationUnit(clang::ASTContext& context) override {
    const auto& sources = context.getSourceManager();
    std::vector<clang::Decl*> ours;
    for (auto* declaration : context.getTranslationUnitDecl()->decls()) {
      const auto at = sources.getExpansionLoc(declaration->getLocation());
      if (at.isValid() && !sources.isInSystemHeader(at)) ours.push_back(declaration);
    }
    context.setTraversalScope(ours);
  }
};

class ScopeAction final : public clang::PluginASTAction {
 protected:
  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance&, llvm::StringRef) override {
    return std::make_unique<Scope>();
  }
  bool ParseArgs(const clang::CompilerInstance&, const std::vector<std::string>&) override { return true; }
  ActionType getActionType() override { return AddBeforeMainAction; }
};

const clang::FrontendPluginRegistry::Add<ScopeAction> scope("scope",
                                                            "checks walk over our declarations alone");

}  // namespace
