package org.hificamsim.core;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a package that other programs may build on: its public types keep names, signatures and
 * meaning for as long as the version's first number stays (before 1.0: its second). They expose
 * nothing but the JDK's types and other stable packages'.
 */
@Documented
@Target(ElementType.PACKAGE)
@Retention(RetentionPolicy.RUNTIME)
public @interface StableApi {
  /** The version that made the promise. */
  String since();
}
