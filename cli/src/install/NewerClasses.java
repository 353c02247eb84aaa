import java.io.IOException;
import java.io.OutputStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Collections;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import jdk.internal.org.objectweb.asm.ClassReader;
import jdk.internal.org.objectweb.asm.ClassVisitor;
import jdk.internal.org.objectweb.asm.ClassWriter;
import jdk.internal.org.objectweb.asm.Opcodes;

/**
 * Rewrites the class files of a jar from the format of Java 5 to that of Java 8, because the class
 * archives of JDK 17 cannot contain older ones. The code stays the same. Needs the copy of ASM in
 * JDK 17:
 *
 * <pre>
 * java --add-exports java.base/jdk.internal.org.objectweb.asm=ALL-UNNAMED NewerClasses.java JAR
 * </pre>
 */
final class NewerClasses {
  private static final int OFFSET_OF_MAJOR_VERSION = 7;

  private NewerClasses() {}

  public static void main(String[] args) throws IOException {
    Path jar = Path.of(args[0]);
    Path newer = Path.of(args[0] + ".new");
    write(jar, newer);
    Files.move(newer, jar, StandardCopyOption.ATOMIC_MOVE);
  }

  private static void write(Path jar, Path newer) throws IOException {
    try (ZipFile in = new ZipFile(jar.toFile());
        URLClassLoader loader = new URLClassLoader(new URL[] {jar.toUri().toURL()});
        OutputStream file = Files.newOutputStream(newer);
        ZipOutputStream out = new ZipOutputStream(file)) {
      for (ZipEntry entry : Collections.list(in.entries())) {
        byte[] content = in.getInputStream(entry).readAllBytes();
        boolean isOld =
            entry.getName().endsWith(".class") && content[OFFSET_OF_MAJOR_VERSION] < Opcodes.V1_6;
        ZipEntry copy = new ZipEntry(entry.getName());
        copy.setTime(entry.getTime());
        out.putNextEntry(copy);
        out.write(isOld ? newer(content, loader) : content);
      }
    }
  }

  private static byte[] newer(byte[] content, ClassLoader loader) {
    ClassWriter writer =
        new ClassWriter(ClassWriter.COMPUTE_FRAMES) {
          @Override
          protected ClassLoader getClassLoader() {
            return loader;
          }
        };
    ClassVisitor visitor =
        new ClassVisitor(Opcodes.ASM8, writer) {
          @Override
          public void visit(
              int version,
              int access,
              String name,
              String type,
              String parent,
              String[] interfaces) {
            super.visit(Opcodes.V1_8, access, name, type, parent, interfaces);
          }
        };
    new ClassReader(content).accept(visitor, ClassReader.SKIP_FRAMES);
    return writer.toByteArray();
  }
}
