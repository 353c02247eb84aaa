package org.hificamsim.core.registry;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Nearest;

/**
 * The implementations of one extension point by name, in the order of registration.
 *
 * <p>A name may hold colons ({@code hifi:orb-lin}); what follows a registered name and a further
 * colon are its {@link Options}. Lookup makes a new instance each time. Safe for use by several
 * threads.
 *
 * @param <T> the extension point
 */
public final class Registry<T> {
  /** One registered implementation. */
  public record Entry<T>(String name, String summary, Function<Options, T> factory) {}

  private final String kind;
  private final Map<String, Entry<T>> entries = new LinkedHashMap<>();
  private final Map<String, String> aliases = new HashMap<>();
  private final Deque<Consumer<Registry<T>>> unread = new ArrayDeque<>();

  /**
   * @param kind the extension point as messages name it, such as "policy"
   */
  public Registry(String kind) {
    this.kind = kind;
  }

  /**
   * Adds an implementation.
   *
   * @throws InputException if the name is taken: a user's jar cannot replace a built-in one
   */
  public synchronized Registry<T> register(
      String name, String summary, Function<Options, T> factory) {
    if (aliases.containsKey(name)
        || entries.putIfAbsent(name, new Entry<>(name, summary, factory)) != null) {
      throw InputException.of("%s '%s' is registered twice, expected each name once", kind, name);
    }
    return this;
  }

  /**
   * Adds another name for an implementation, which is accepted but not listed.
   *
   * @param name a registered name
   * @throws InputException if the name is not registered or the alias is taken
   */
  public synchronized Registry<T> alias(String alias, String name) {
    if (!entries.containsKey(name) || entry(alias) != null) {
      throw InputException.of(
          "%s '%s' for '%s': expected a new name for a registered one", kind, alias, name);
    }
    aliases.put(alias, name);
    return this;
  }

  /**
   * Adds implementations that take time to read. They are registered when a name is not known
   * without them, or all names are asked for.
   *
   * @param members registers them
   */
  public synchronized Registry<T> registerWhenNeeded(Consumer<Registry<T>> members) {
    unread.add(members);
    return this;
  }

  /** Adds an implementation without options. */
  public Registry<T> register(String name, String summary, java.util.function.Supplier<T> maker) {
    return register(name, summary, options -> maker.get());
  }

  /**
   * Adds every implementation that jars on the class path declare as a service. Each needs a public
   * constructor without arguments; every lookup makes a new instance.
   */
  public Registry<T> registerServices(
      Class<T> type, Function<T, String> name, BiConsumer<T, Options> configure) {
    ServiceLoader.load(type).stream()
        .forEach(
            provider ->
                register(
                    name.apply(provider.get()),
                    provider.type().getName(),
                    options -> {
                      T instance = provider.get();
                      configure.accept(instance, options);
                      return instance;
                    }));
    return this;
  }

  /**
   * Makes the implementation that {@code spec} names.
   *
   * @param spec {@code NAME} or {@code NAME:key=value,...}
   * @throws InputException if the name, an option or a value is unknown
   */
  public T create(String spec) {
    int end = nameEnd(spec);
    if (end > 0) {
      return create(
          entry(spec.substring(0, end)), spec.substring(Math.min(end + 1, spec.length())));
    }
    throw InputException.of(
        "unknown %s '%s', expected %s",
        kind,
        spec,
        names().isEmpty()
            ? "none: no jar on the class path brings one"
            : "one of " + Nearest.to(spec.replaceFirst(":[^:]*=.*", ""), names()));
  }

  private synchronized Entry<T> entry(String name) {
    return entries.get(aliases.getOrDefault(name, name));
  }

  /** Whether {@code spec} starts with a registered name. */
  public boolean knows(String spec) {
    return nameEnd(spec) > 0;
  }

  /** The end of the registered name with which {@code spec} starts; 0 or less without one. */
  private synchronized int nameEnd(String spec) {
    int end = spec.length();
    while (end > 0 && entry(spec.substring(0, end)) == null) {
      end = spec.lastIndexOf(':', end - 1);
    }
    return end > 0 || unread.isEmpty() ? end : all().nameEnd(spec);
  }

  /** This registry with all implementations. */
  private synchronized Registry<T> all() {
    while (!unread.isEmpty()) {
      unread.remove().accept(this);
    }
    return this;
  }

  /** The options that an implementation declares, with their defaults. */
  public List<Options.Declared> options(String name) {
    Options options = Options.none(kind + " " + name);
    Object made = all().entry(name).factory().apply(options);
    return made == null ? List.of() : options.declared();
  }

  /** All entries, in the order of registration. */
  public synchronized List<Entry<T>> entries() {
    return List.copyOf(all().entries.values());
  }

  /** All names, in the order of registration. */
  public synchronized List<String> names() {
    return new ArrayList<>(all().entries.keySet());
  }

  private T create(Entry<T> entry, String optionText) {
    String owner = kind + " " + entry.name();
    Options options = optionText.isEmpty() ? Options.none(owner) : Options.parse(owner, optionText);
    T made = entry.factory().apply(options);
    options.rejectUnknown();
    return made;
  }
}
