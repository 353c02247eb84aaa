package org.hificamsim.bridge.camsim;

import static net.bytebuddy.matcher.ElementMatchers.named;
import static net.bytebuddy.matcher.ElementMatchers.takesArgument;
import static net.bytebuddy.matcher.ElementMatchers.takesArguments;

import java.lang.instrument.ClassFileTransformer;
import java.lang.instrument.Instrumentation;
import java.security.ProtectionDomain;
import java.util.HashMap;
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
  private final Map<String, List<AsmVisitorWrapper>> hooks = new HashMap<>();
  private final Consumer<Throwable> onFailure;

  private Weaver(boolean tracks, Consumer<Throwable> onFailure) {
    this.onFailure = onFailure;
    hooks.put(
        Names.CORE,
        List.of(hook(StepAdvice.class, Names.UPDATE), hook(EndAdvice.class, Names.CLOSE_FILES)));
    hooks.put(Names.CAMERA, List.of(hook(LookAdvice.class, Names.LOOK)));
    if (tracks) {
      hooks.put(
          Names.OBJECT,
          List.of(
              hook(PlaceXAdvice.class, Names.TRACKED_X),
              hook(PlaceYAdvice.class, Names.TRACKED_Y)));
    }
  }

  /**
   * Has the hooks woven from now on.
   *
   * @param tracks whether objects follow tracks
   * @param onFailure called when a class cannot be changed; CamSim then gets it as it was
   */
  public static void weave(
      Instrumentation instrumentation, boolean tracks, Consumer<Throwable> onFailure) {
    instrumentation.addTransformer(new Weaver(tracks, onFailure));
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
