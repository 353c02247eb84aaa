package org.hificamsim.bridge.agent;

import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;

/**
 * Loads the bridge and its libraries from the folder {@code isolated/} of the agent's jar. Neither
 * this loader nor that of CamSim's class path is a parent of the other, so neither sees the
 * libraries of the other, whatever their versions. Only this package is shared.
 */
final class IsolatedLoader extends URLClassLoader {
  private static final String SHARED = IsolatedLoader.class.getPackage().getName() + ".";

  /**
   * @param jar the agent's jar
   */
  IsolatedLoader(URL jar) throws MalformedURLException {
    // The parent of the system class loader has the classes of the JDK, but none of the class path.
    super(
        new URL[] {new URL("jar:" + jar + "!/isolated/")},
        ClassLoader.getSystemClassLoader().getParent());
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    return name.startsWith(SHARED) ? Class.forName(name) : super.findClass(name);
  }
}
