package org.hificamsim.acceptance;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static java.util.stream.Collectors.toSet;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
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
import java.io.IOException;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.regex.Pattern;
import org.hificamsim.core.StableApi;
import org.hificamsim.core.policy.OracleView;

/** Tests that modules, and packages of a module, use each other in one direction only. */
@AnalyzeClasses(packages = "org.hificamsim", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
  private static final DescribedPredicate<JavaClass> ARE_STABLE =
      DescribedPredicate.describe(
          "are in a stable package", type -> type.getPackage().isAnnotatedWith(StableApi.class));

  @ArchTest
  static void modulesDependOneWay(JavaClasses classes) {
    var modules =
        layeredArchitecture()
            .consideringOnlyDependenciesInLayers()
            .ensureAllClassesAreContainedInArchitecture();
    for (Module module : Module.values()) {
      modules = modules.layer(module.folder).definedBy(module.packages());
    }
    for (Module module : Module.values()) {
      modules = modules.whereLayer(module.folder).mayOnlyAccessLayers(module.reached());
    }
    modules.check(classes);
  }

  @ArchTest
  static void everyModuleIsKnown(JavaClasses classes) throws IOException {
    String settings = Files.readString(Cli.ROOT.resolve("settings.gradle"));
    assertEquals(
        Arrays.stream(Module.values()).map(module -> module.folder).collect(toSet()),
        Pattern.compile("'([a-z-]+)'")
            .matcher(settings.substring(settings.indexOf("include")))
            .results()
            .map(name -> name.group(1))
            .collect(toSet()));
  }

  @ArchTest
  static final ArchRule coreDependsOnlyOnTheJdk =
      classes()
          .that()
          .resideInAPackage("org.hificamsim.core..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage("org.hificamsim.core..", "java..", "javax.xml..", "org.xml.sax..");

  /** These modules go into the jar of the agent, which must stay small. */
  @ArchTest
  static final ArchRule bridgeDependsOnlyOnLightLibraries =
      classes()
          .that()
          .resideInAnyPackage(
              "org.hificamsim.bridge..", "org.hificamsim.catalogue..", "org.hificamsim.runs..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage(
              "org.hificamsim.bridge..",
              "org.hificamsim.catalogue..",
              "org.hificamsim.runs..",
              "org.hificamsim.agents..",
              "org.hificamsim.hifi..",
              "org.hificamsim.data..",
              "org.hificamsim.core..",
              "com.fasterxml.jackson..",
              "org.apache.commons.math3..",
              "net.bytebuddy..",
              "java..",
              "javax.xml.stream..");

  /** The class loader of CamSim sees these classes, on any version of Java. */
  @ArchTest
  static final ArchRule agentDependsOnlyOnTheJdk =
      classes()
          .that()
          .resideInAPackage("org.hificamsim.bridge.agent..")
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage("org.hificamsim.bridge.agent..", "java..");

  @ArchTest
  static final ArchRule stablePackagesExposeOnlyStableTypes =
      classes().that(ARE_STABLE).and().arePublic().should(exposeOnlyStableTypes());

  @ArchTest
  static final ArchRule packagesHaveNoCycles =
      slices().matching("org.hificamsim.(**)").should().beFreeOfCycles();

  /** Policies and baselines decide from what cameras know, except for one declared bound. */
  @ArchTest
  static final ArchRule onlyBoundsUseTheOracle =
      noClasses()
          .that()
          .resideInAPackage("org.hificamsim.agents..")
          .and()
          .resideOutsideOfPackage("org.hificamsim.agents.optimal..")
          .and()
          .doNotHaveSimpleName("IndependentGreedyZoomPolicy")
          .should()
          .dependOnClassesThat()
          .areAssignableTo(OracleView.class);

  @ArchTest
  static final ArchRule nothingUsesAmbientRandomness =
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
