package org.hificamsim.acceptance;

import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;

/** The modules. Each may use the modules that are named behind it, and all that these use. */
enum Module {
  CORE("camsim-core"),
  DATA("data", CORE),
  HIFI("hifi-detection", DATA),
  SOLVER("solver", CORE),
  AGENTS("coverage-agents", SOLVER),
  CATALOGUE("catalogue", HIFI, AGENTS),
  RUNS("runs", CATALOGUE),
  WORLDS("worlds", CATALOGUE),
  NETWORK("camsim-network", RUNS),
  TRACKS("tracks", DATA),
  PRESENTATION("presentation", RUNS),
  PROFILING("profiling", PRESENTATION, TRACKS),
  REPRODUCTION("reproduction", PRESENTATION, NETWORK),
  PLACEMENT("placement", PRESENTATION),
  CLI("cli", REPRODUCTION, PLACEMENT, PROFILING, TRACKS, WORLDS),
  ONNX("onnx", WORLDS),
  PARQUET("parquet", RUNS),
  SQLITE("sqlite", TRACKS),
  ORTOOLS("ortools", PLACEMENT),
  PYTHON("python", WORLDS, PRESENTATION),
  BRIDGE("camsim-bridge", RUNS),
  SPARK("spark", RUNS),
  BENCH("bench", PRESENTATION, NETWORK, WORLDS);

  /** The folder of the module, as settings.gradle names it. */
  final String folder;

  @SuppressWarnings("ImmutableEnumChecker") // nothing changes it
  private final Module[] uses;

  Module(String folder, Module... uses) {
    this.folder = folder;
    this.uses = uses;
  }

  /** The packages of the module, in the notation of ArchUnit. */
  String packages() {
    return "org.hificamsim." + name().toLowerCase(Locale.ROOT) + "..";
  }

  /** The folders of all modules that the module may use, including its own. */
  String[] reached() {
    return reach(EnumSet.noneOf(Module.class)).stream().map(m -> m.folder).toArray(String[]::new);
  }

  private Set<Module> reach(Set<Module> found) {
    found.add(this);
    for (Module module : uses) {
      module.reach(found);
    }
    return found;
  }
}
