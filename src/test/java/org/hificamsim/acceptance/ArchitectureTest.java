package org.hificamsim.acceptance;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The one-way arrows between modules, and between the packages of a module. */
@AnalyzeClasses(packages = "org.hificamsim", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
  @ArchTest
  static final ArchRule modulesDependOneWay =
      layeredArchitecture()
          .consideringOnlyDependenciesInLayers()
          .layer("experiments")
          .definedBy("org.hificamsim.experiments..")
          .optionalLayer("profiling")
          .definedBy("org.hificamsim.profiling..")
          .layer("agents")
          .definedBy("org.hificamsim.agents..")
          .layer("hifi")
          .definedBy("org.hificamsim.hifi..")
          .layer("core")
          .definedBy("org.hificamsim.core..")
          .layer("bridge")
          .definedBy("org.hificamsim.bridge..")
          .whereLayer("bridge")
          .mayNotBeAccessedByAnyLayer()
          .whereLayer("experiments")
          .mayOnlyBeAccessedByLayers("bridge")
          .whereLayer("profiling")
          .mayOnlyBeAccessedByLayers("experiments")
          .whereLayer("agents")
          .mayOnlyBeAccessedByLayers("experiments", "bridge")
          .whereLayer("hifi")
          .mayOnlyBeAccessedByLayers("experiments", "profiling", "bridge")
          .whereLayer("core")
          .mayOnlyBeAccessedByLayers("experiments", "profiling", "agents", "hifi", "bridge");

  @ArchTest
  static final ArchRule coreNeedsTheJdkAlone =
      classes()
          .that()
          .resideInAPackage("org.hificamsim.core..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage("org.hificamsim.core..", "java..", "javax.xml..", "org.xml.sax..");

  /** What of the command line is inside the agent's jar, and stays as light as it is. */
  @ArchTest
  static final ArchRule theBridgeTakesNothingHeavyFromExperiments =
      classes()
          .that()
          .resideInAnyPackage(
              "org.hificamsim.bridge..",
              "org.hificamsim.experiments.catalogue..",
              "org.hificamsim.experiments.output..",
              "org.hificamsim.experiments.run..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage(
              "org.hificamsim.bridge..",
              "org.hificamsim.experiments.catalogue..",
              "org.hificamsim.experiments.output..",
              "org.hificamsim.experiments.run..",
              "org.hificamsim.agents..",
              "org.hificamsim.hifi..",
              "org.hificamsim.core..",
              "com.fasterxml.jackson..",
              "org.apache.commons.math3..",
              "net.bytebuddy..",
              "java..",
              "javax.xml.stream..");

  /** CamSim's class loader sees these, whatever its Java. */
  @ArchTest
  static final ArchRule theAgentNeedsTheJdkAlone =
      classes()
          .that()
          .resideInAPackage("org.hificamsim.bridge.agent..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage("org.hificamsim.bridge.agent..", "java..");

  @ArchTest
  static final ArchRule packagesAreFreeOfCycles =
      slices().matching("org.hificamsim.(*).(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule nothingDrawsFromAnAmbientRandomSource =
      noClasses()
          .should()
          .callMethod(Math.class, "random")
          .orShould()
          .dependOnClassesThat()
          .haveFullyQualifiedName("java.util.concurrent.ThreadLocalRandom")
          .orShould()
          .callConstructor(java.util.Random.class)
          .orShould()
          .callConstructor(java.util.SplittableRandom.class);
}
