package org.hificamsim.core;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a package that other programs may build on: its public types keep their names, signatures
 * and meaning within a major version (before 1.0: a minor version), and expose only types of the
 * JDK and of stable packages.
 */
@Documented
@Target(ElementType.PACKAGE)
@Retention(RetentionPolicy.RUNTIME)
public @interface StableApi {
  /** The version that made the promise. */
  String since();
}
