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
          .layer("catalogue")
          .definedBy("org.hificamsim.catalogue..")
          .layer("agents")
          .definedBy("org.hificamsim.agents..")
          .layer("hifi")
          .definedBy("org.hificamsim.hifi..")
          .layer("core")
          .definedBy("org.hificamsim.core..")
          .whereLayer("experiments")
          .mayNotBeAccessedByAnyLayer()
          .whereLayer("profiling")
          .mayOnlyBeAccessedByLayers("experiments")
          .whereLayer("catalogue")
          .mayOnlyBeAccessedByLayers("experiments")
          .whereLayer("agents")
          .mayOnlyBeAccessedByLayers("experiments", "catalogue")
          .whereLayer("hifi")
          .mayOnlyBeAccessedByLayers("experiments", "catalogue", "profiling")
          .whereLayer("core")
          .mayOnlyBeAccessedByLayers("experiments", "catalogue", "profiling", "agents", "hifi");

  @ArchTest
  static final ArchRule coreNeedsTheJdkAlone =
      classes()
          .that()
          .resideInAPackage("org.hificamsim.core..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage("org.hificamsim.core..", "java..", "javax.xml..", "org.xml.sax..");

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
