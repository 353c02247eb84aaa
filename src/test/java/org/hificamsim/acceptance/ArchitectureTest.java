package org.hificamsim.acceptance;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvent;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import org.hificamsim.core.StableApi;

/** The one-way arrows between modules, and between the packages of a module. */
@AnalyzeClasses(packages = "org.hificamsim", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
  private static final DescribedPredicate<JavaClass> ARE_STABLE =
      DescribedPredicate.describe(
          "are in a stable package", type -> type.getPackage().isAnnotatedWith(StableApi.class));

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
          .layer("bridge")
          .definedBy("org.hificamsim.bridge..")
          .whereLayer("bridge")
          .mayNotBeAccessedByAnyLayer()
          .whereLayer("experiments")
          .mayOnlyBeAccessedByLayers("bridge")
          .whereLayer("profiling")
          .mayOnlyBeAccessedByLayers("experiments")
          .whereLayer("catalogue")
          .mayOnlyBeAccessedByLayers("experiments", "bridge")
          .whereLayer("agents")
          .mayOnlyBeAccessedByLayers("catalogue", "experiments", "bridge")
          .whereLayer("hifi")
          .mayOnlyBeAccessedByLayers("catalogue", "experiments", "profiling", "bridge")
          .whereLayer("core")
          .mayOnlyBeAccessedByLayers(
              "catalogue", "experiments", "profiling", "agents", "hifi", "bridge");

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
              "org.hificamsim.catalogue..",
              "org.hificamsim.experiments.output..",
              "org.hificamsim.experiments.run..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage(
              "org.hificamsim.bridge..",
              "org.hificamsim.catalogue..",
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
  static final ArchRule stablePackagesExposeNothingThatMayChange =
      classes().that(ARE_STABLE).and().arePublic().should(exposeOnlyStableTypes());

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

  private static ArchCondition<JavaClass> exposeOnlyStableTypes() {
    return new ArchCondition<>("expose types of the JDK and of stable packages alone") {
      @Override
      public void check(JavaClass type, ConditionEvents events) {
        type.getMembers().stream()
            .filter(ArchitectureTest::isExposed)
            .forEach(
                member ->
                    member.getAllInvolvedRawTypes().stream()
                        .map(JavaClass::getBaseComponentType)
                        .filter(used -> !mayBeExposed(used))
                        .forEach(used -> events.add(violated(member, used))));
      }
    };
  }

  private static ConditionEvent violated(JavaMember member, JavaClass used) {
    return SimpleConditionEvent.violated(
        member, member.getFullName() + " exposes " + used.getName());
  }

  private static boolean isExposed(JavaMember member) {
    return member.getModifiers().contains(JavaModifier.PUBLIC)
        || member.getModifiers().contains(JavaModifier.PROTECTED);
  }

  private static boolean mayBeExposed(JavaClass type) {
    return type.isPrimitive() || type.getPackageName().startsWith("java.") || ARE_STABLE.test(type);
  }
}
