package org.hificamsim.bridge.camsim;

import static net.bytebuddy.matcher.ElementMatchers.named;
import static net.bytebuddy.matcher.ElementMatchers.takesArgument;
import static net.bytebuddy.matcher.ElementMatchers.takesArguments;

import java.lang.instrument.ClassFileTransformer;
import java.lang.instrument.Instrumentation;
import java.security.ProtectionDomain;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import net.bytebuddy.ByteBuddy;
import net.bytebuddy.asm.Advice;
import net.bytebuddy.asm.AsmVisitorWrapper;
import net.bytebuddy.description.method.MethodDescription;
import net.bytebuddy.description.type.TypeDescription;
import net.bytebuddy.dynamic.ClassFileLocator;
import net.bytebuddy.dynamic.DynamicType;
import net.bytebuddy.matcher.ElementMatcher;
import net.bytebuddy.matcher.ElementMatchers;
import net.bytebuddy.pool.TypePool;

/** Weaves the hooks into CamSim's classes when the JVM loads them. */
public final class Weaver implements ClassFileTransformer {
  private final Map<String, List<AsmVisitorWrapper>> hooks =
      Map.of(
          Names.CORE,
          List.of(hook(StepAdvice.class, Names.UPDATE), hook(EndAdvice.class, Names.CLOSE_FILES)),
          Names.CAMERA,
          List.of(hook(LookAdvice.class, Names.LOOK)));
  private final Consumer<Throwable> onFailure;

  private Weaver(Consumer<Throwable> onFailure) {
    this.onFailure = onFailure;
  }

  /**
   * Has the hooks woven from now on.
   *
   * @param onFailure called when a class cannot be changed; CamSim then gets it as it was
   */
  public static void weave(Instrumentation instrumentation, Consumer<Throwable> onFailure) {
    instrumentation.addTransformer(new Weaver(onFailure));
  }

  @Override
  public byte[] transform(
      ClassLoader loader, String path, Class<?> before, ProtectionDomain domain, byte[] bytes) {
    List<AsmVisitorWrapper> wanted = path == null ? null : hooks.get(path.replace('/', '.'));
    if (wanted == null) {
      return null;
    }
    String name = path.replace('/', '.');
    try {
      return woven(name, bytes, loader, wanted);
    } catch (Throwable e) {
      onFailure.accept(new IllegalStateException(name + " cannot be changed: " + e, e));
      return null;
    }
  }

  private static byte[] woven(
      String name, byte[] bytes, ClassLoader loader, List<AsmVisitorWrapper> wanted) {
    ClassFileLocator locator =
        new ClassFileLocator.Compound(
            ClassFileLocator.Simple.of(name, bytes), ClassFileLocator.ForClassLoader.of(loader));
    TypeDescription type = TypePool.Default.of(locator).describe(name).resolve();
    DynamicType.Builder<?> builder = new ByteBuddy().decorate(type, locator);
    for (AsmVisitorWrapper hook : wanted) {
      builder = builder.visit(hook);
    }
    return builder.make(TypePool.Default.of(locator)).getBytes();
  }

  private static AsmVisitorWrapper hook(Class<?> advice, CamSimMethod method) {
    ElementMatcher.Junction<MethodDescription> matcher =
        ElementMatchers.<MethodDescription>named(method.name())
            .and(takesArguments(method.parameters().size()));
    for (int i = 0; i < method.parameters().size(); i++) {
      matcher = matcher.and(takesArgument(i, named(method.parameters().get(i))));
    }
    return Advice.to(advice).on(matcher);
  }
}
