package org.hificamsim.bridge.camsim;

import java.lang.instrument.ClassFileTransformer;
import java.lang.instrument.Instrumentation;
import java.security.ProtectionDomain;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import net.bytebuddy.ByteBuddy;
import net.bytebuddy.asm.Advice;
import net.bytebuddy.description.type.TypeDescription;
import net.bytebuddy.dynamic.ClassFileLocator;
import net.bytebuddy.dynamic.DynamicType;
import net.bytebuddy.pool.TypePool;

/** Inserts the hooks into CamSim's classes when the JVM loads them. */
public final class Weaver implements ClassFileTransformer {
  private final List<CamSimMethod> woven;
  private final Consumer<Throwable> onFailure;

  private Weaver(Set<Use> uses, Consumer<Throwable> onFailure) {
    this.onFailure = onFailure;
    woven =
        Arrays.stream(CamSimMethod.values())
            .filter(method -> method.advice != null)
            .filter(method -> method.use != Use.TRACK || uses.contains(Use.TRACK))
            .toList();
  }

  /**
   * Starts weaving hooks into classes that are loaded from now on.
   *
   * @param onFailure action to run if a class cannot be changed; CamSim then gets the original
   *     class
   */
  public static void weave(
      Instrumentation instrumentation, Set<Use> uses, Consumer<Throwable> onFailure) {
    instrumentation.addTransformer(new Weaver(uses, onFailure));
  }

  @Override
  public byte[] transform(
      ClassLoader loader, String path, Class<?> before, ProtectionDomain domain, byte[] bytes) {
    String name = path == null ? "" : path.replace('/', '.');
    List<CamSimMethod> wanted =
        woven.stream().filter(method -> method.type.name.equals(name)).toList();
    if (wanted.isEmpty()) {
      return null;
    }
    try {
      return woven(name, bytes, loader, wanted);
    } catch (Throwable e) {
      onFailure.accept(new IllegalStateException(name + " cannot be changed: " + e, e));
      return null;
    }
  }

  private static byte[] woven(
      String name, byte[] bytes, ClassLoader loader, List<CamSimMethod> wanted) {
    ClassFileLocator locator =
        new ClassFileLocator.Compound(
            ClassFileLocator.Simple.of(name, bytes), ClassFileLocator.ForClassLoader.of(loader));
    TypeDescription type = TypePool.Default.of(locator).describe(name).resolve();
    DynamicType.Builder<?> builder = new ByteBuddy().decorate(type, locator);
    for (CamSimMethod method : wanted) {
      builder =
          builder.visit(Advice.to(method.advice).on(found -> Requirements.matches(method, found)));
    }
    return builder.make(TypePool.Default.of(locator)).getBytes();
  }
}
