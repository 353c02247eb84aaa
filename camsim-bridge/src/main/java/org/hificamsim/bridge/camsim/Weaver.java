package org.hificamsim.bridge.camsim;

import static net.bytebuddy.matcher.ElementMatchers.named;
import static net.bytebuddy.matcher.ElementMatchers.takesArguments;

import java.lang.instrument.Instrumentation;
import java.util.function.Consumer;
import net.bytebuddy.agent.builder.AgentBuilder;
import net.bytebuddy.asm.Advice;
import net.bytebuddy.asm.AsmVisitorWrapper;
import net.bytebuddy.utility.JavaModule;

/** Weaves the hooks into CamSim's classes when the JVM loads them. */
public final class Weaver {
  private Weaver() {}

  /**
   * Has the hooks woven from now on.
   *
   * @param onFailure told when a class cannot be changed; CamSim then gets it as it was
   */
  public static void weave(Instrumentation instrumentation, Consumer<Throwable> onFailure) {
    new AgentBuilder.Default()
        .disableClassFormatChanges()
        .with(new FailureListener(onFailure))
        .type(named(Names.CORE))
        .transform(
            (builder, type, loader, module, domain) ->
                builder
                    .visit(hook(StepAdvice.class, Names.UPDATE))
                    .visit(hook(EndAdvice.class, Names.CLOSE_FILES)))
        .type(named(Names.CAMERA))
        .transform(
            (builder, type, loader, module, domain) ->
                builder.visit(hook(LookAdvice.class, Names.LOOK)))
        .installOn(instrumentation);
  }

  private static AsmVisitorWrapper hook(Class<?> advice, Method method) {
    return Advice.to(advice)
        .on(named(method.name()).and(takesArguments(method.parameters().size())));
  }

  /** Tells failures to weave. */
  private static final class FailureListener extends AgentBuilder.Listener.Adapter {
    private final Consumer<Throwable> onFailure;

    FailureListener(Consumer<Throwable> onFailure) {
      this.onFailure = onFailure;
    }

    @Override
    public void onError(
        String type, ClassLoader loader, JavaModule module, boolean loaded, Throwable fault) {
      if (type.equals(Names.CORE) || type.equals(Names.CAMERA)) {
        onFailure.accept(new IllegalStateException(type + " cannot be changed: " + fault, fault));
      }
    }
  }
}
