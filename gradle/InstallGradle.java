import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.math.BigInteger;
import java.net.URISyntaxException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/**
 * Puts Gradle 8.7 together from Maven Central, for machines that cannot reach Gradle's own server.
 *
 * <p>gradlew and gradlew.bat start it while Gradle is not installed; to run it by hand, use {@code java gradle/InstallGradle.java}. It
 * needs JDK 17 or newer and {@code mvn} on the PATH, and uses Maven's mirrors and proxies. It does nothing if the wrapper can download
 * Gradle.
 *
 * <p>{@code dev.gradleplugins:gradle-api} contains nearly every class of Gradle in one jar. The Gradle home consists of that jar with a few
 * changes, and the libraries in {@link #PARTS}.
 *
 * <p>The file is plain ASCII, because Java 17 reads it in the platform's own encoding.
 */
public final class InstallGradle {
    private static final String VERSION = "8.7";

    /** The versions that Gradle 8.7 itself comes with; {@code gradle --version} prints them. */
    private static final String KOTLIN = "1.9.22";
    private static final String GROOVY = "3.0.17";

    private static final Part GRADLE_API = new Part("dev.gradleplugins", "gradle-api", VERSION,
        "3977770bbfdf27e04c5a136810c092aa88841c63c44cb954b0135dd875ca9cc8");

    private static final List<Part> PARTS = List.of(
        GRADLE_API,
        kotlin("kotlin-stdlib", "6abe146c27864138b874ccccfe5f534e3eb923c99a1b7b5d45494ee5694f3e0a"),
        kotlin("kotlin-reflect", "77f311ca1384811d519fda389fcb1268bdaa058d605046e0ede76c03b0df3e97"),
        groovy("groovy", "9ed2a565a8592a9f63f410afed892d0ca6bec1ff96277ce4cc7f3e2e366e794f"),
        groovy("groovy-ant", "baf25567b0a5c7e13fe57a48d1f7458cafb33bed8e4f0aefa1874491f8291c51"),
        groovy("groovy-json", "f577bd1551570162d42f22373ff164894ebf2f295d72d8ee914866aaa2ac37d4"),
        groovy("groovy-templates", "64aea1cad62685bbf71d4a69ca5b21ff1b50d4bb364b0c1308170e6f3ad317a3"),
        groovy("groovy-xml", "52fc4047a3dcb870b05ad73f6b1dcebb5a0ae97b5a58f58b581f8960ab128ab1"));

    private static final String COPY = "org.apache.maven.plugins:maven-dependency-plugin:3.6.1:copy-dependencies";

    private InstallGradle() {
    }

    public static void main(String[] args) throws InterruptedException {
        try {
            Path wrapper = sourceFile().resolveSibling("wrapper");
            Properties properties = new Properties();
            try (Reader reader = Files.newBufferedReader(wrapper.resolve("gradle-wrapper.properties"))) {
                properties.load(reader);
            }
            String address = properties.getProperty("distributionUrl", "");
            String zip = address.substring(address.lastIndexOf('/') + 1);
            Path place = place(address, zip);
            if (Files.exists(place.resolve(zip + ".ok")) || wrapperWorks(wrapper.resolve("gradle-wrapper.jar"))) {
                return;
            }
            if (!zip.equals("gradle-" + VERSION + "-bin.zip")) {
                throw new IOException("it is not the Gradle that the distributionUrl asks for, " + zip);
            }
            install(place, zip);
        } catch (IOException | UncheckedIOException e) {
            // Java's messages are often only a path; the name of the exception describes the problem.
            String reason = e.getClass() == IOException.class ? e.getMessage() : e.toString();
            System.err.println("Gradle " + VERSION + " could not be put together: " + reason + ". Fix that, or give this machine"
                + " access to the distributionUrl in gradle/wrapper/gradle-wrapper.properties, then try again.");
            System.exit(1);
        }
    }

    private static Path sourceFile() throws IOException {
        try {
            return Path.of(InstallGradle.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        } catch (URISyntaxException e) {
            throw new IOException("the folder of this program is not found", e);
        }
    }

    /** Returns the folder in which the wrapper looks for Gradle: below a hash of the address without user and password. */
    private static Path place(String address, String zip) {
        String userHome = System.getenv("GRADLE_USER_HOME");
        Path folder = userHome == null ? Path.of(System.getProperty("user.home"), ".gradle") : Path.of(userHome);
        byte[] bytes = address.replaceFirst("//[^/]*@", "//").getBytes(StandardCharsets.UTF_8);
        String hash = new BigInteger(1, digest("MD5").digest(bytes)).toString(36);
        return folder.toAbsolutePath().resolve(Path.of("wrapper", "dists", zip.replace(".zip", ""), hash));
    }

    /** Returns whether the wrapper can download Gradle, which may need proxies and passwords that only the wrapper knows. */
    private static boolean wrapperWorks(Path jar) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        for (String variable : List.of("JAVA_OPTS", "GRADLE_OPTS")) {
            String options = System.getenv().getOrDefault(variable, "");
            Stream.of(options.split(" ")).filter(option -> !option.isEmpty()).forEach(command::add);
        }
        command.addAll(List.of("-classpath", jar.toString(), "org.gradle.wrapper.GradleWrapperMain", "--version"));
        return new ProcessBuilder(command).inheritIO().redirectError(ProcessBuilder.Redirect.DISCARD).start().waitFor() == 0;
    }

    /** Installs Gradle under the wrapper's own lock, so that an IDE's wrapper waits, too. */
    private static void install(Path place, String zip) throws IOException, InterruptedException {
        Path marker = place.resolve(zip + ".ok");
        Files.createDirectories(place);
        try (FileChannel channel = FileChannel.open(place.resolve(zip + ".lck"), StandardOpenOption.CREATE,
                StandardOpenOption.WRITE);
             FileLock lock = channel.lock()) {
            if (Files.exists(marker)) {
                return;
            }
            System.err.println("Gradle cannot be downloaded from its own server: putting Gradle " + VERSION + " together from"
                + " Maven Central instead (once, up to 200 MB)...");
            Path work = place.resolveSibling(place.getFileName() + ".partial");
            deleteTree(work);
            try {
                Path home = build(work);
                Path target = place.resolve(home.getFileName());
                deleteTree(target);
                Files.move(home, target, StandardCopyOption.ATOMIC_MOVE);
                // The marker comes last, because without it the wrapper treats Gradle as not installed.
                Files.createFile(marker);
            } finally {
                deleteTree(work);
            }
        }
    }

    private static Path build(Path work) throws IOException, InterruptedException {
        Path home = work.resolve("gradle-" + VERSION);
        // Gradle accepts a lib folder as its own only if it contains plugins.
        Path lib = Files.createDirectories(home.resolve("lib").resolve("plugins")).getParent();
        fetch(work, lib);
        Path jar = lib.resolve("gradle-launcher-" + VERSION + ".jar");
        adapt(Files.move(lib.resolve(GRADLE_API.fileName()), jar), work);
        // The instrumentation agent is not in gradle-api.
        Files.writeString(home.resolve("gradle.properties"), "org.gradle.internal.instrumentation.agent=false\n");
        return home;
    }

    /** Downloads all libraries by Maven, with relative paths only, which are safe on a Windows command line. */
    private static void fetch(Path work, Path lib) throws IOException, InterruptedException {
        Files.writeString(work.resolve("pom.xml"), """
            <project>
              <modelVersion>4.0.0</modelVersion>
              <groupId>none</groupId>
              <artifactId>gradle-parts</artifactId>
              <version>1</version>
              <dependencies>
            %s  </dependencies>
            </project>
            """.formatted(PARTS.stream().map(Part::dependency).collect(Collectors.joining())));
        String mvn = File.separatorChar == '\\' ? "mvn.cmd" : "mvn";
        Process maven;
        try {
            maven = new ProcessBuilder(mvn, "-q", "-B", COPY, "-DoutputDirectory=" + work.relativize(lib))
                .directory(work.toFile()).inheritIO().start();
        } catch (IOException e) {
            throw new IOException(mvn + " does not start; install Maven 3.6 or newer and put it on the PATH", e);
        }
        Runtime.getRuntime().addShutdownHook(new Thread(maven::destroy));
        if (maven.waitFor() != 0) {
            throw new IOException("Maven did not deliver the parts, see above");
        }
        for (Part part : PARTS) {
            String actual = sha256(lib.resolve(part.fileName()));
            if (!actual.equals(part.sha256())) {
                throw new IOException(part.fileName() + " from Maven has the SHA-256 " + actual + " instead of " + part.sha256()
                    + "; delete it from Maven's local repository, or ask whoever runs the mirror that it came from");
            }
        }
    }

    /** Changes the jar in place: only changed entries are compressed again. */
    private static void adapt(Path jar, Path work) throws IOException {
        Path classes = compileStandIns(jar, work);
        try (FileSystem zip = FileSystems.newFileSystem(jar)) {
            for (Path file : files(classes)) {
                Path target = zip.getPath(classes.relativize(file).toString());
                Files.createDirectories(target.getParent());
                Files.copy(file, target, StandardCopyOption.REPLACE_EXISTING);
            }
            for (Path file : files(zip.getPath("org/gradle/api/internal/tasks/testing"))) {
                if (file.toString().endsWith(".class")) {
                    Files.write(file, withJUnitsOwnNames(Files.readAllBytes(file)));
                }
            }
            Files.writeString(zip.getPath("META-INF/services/org.gradle.initialization.GradleApiSpecProvider"),
                "\norg.gradle.kotlin.dsl.provider.KotlinStdlibApi\n", StandardOpenOption.APPEND);
            // Gradle's --version fails without it.
            Files.writeString(zip.getPath("gradle-kotlin-dsl-versions.properties"), "kotlin=" + KOTLIN + "\n");
            // The first entry makes Gradle show all of its classes to plugins; the others hide classes and stop the daemon.
            Files.delete(zip.getPath("META-INF/.gradle-runtime-shaded"));
            Files.delete(zip.getPath("META-INF/INDEX.LIST"));
            Files.delete(zip.getPath("META-INF/services/java.nio.file.spi.FileSystemProvider"));
        }
    }

    /**
     * Restores the original names of JUnit's classes; gradle-api moves all libraries into a package of its own.
     *
     * <p>Every name in a class is a Utf8 entry of its constant pool.
     */
    private static byte[] withJUnitsOwnNames(byte[] classFile) throws IOException {
        ByteArrayOutputStream result = new ByteArrayOutputStream(classFile.length);
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(classFile));
        DataOutputStream out = new DataOutputStream(result);
        out.writeLong(in.readLong()); // magic number and version of the format
        int count = in.readUnsignedShort();
        out.writeShort(count);
        for (int index = 1; index < count; index++) {
            int tag = in.readUnsignedByte();
            out.writeByte(tag);
            switch (tag) {
                case 1 -> out.writeUTF(in.readUTF()
                    .replace("org/gradle/internal/impldep/org/junit", "org/junit")
                    .replace("org.gradle.internal.impldep.org.junit", "org.junit"));
                case 5, 6 -> { // Long and Double take two places of the pool
                    out.writeLong(in.readLong());
                    index++;
                }
                case 7, 8, 16, 19, 20 -> out.writeShort(in.readShort());
                case 15 -> out.write(in.readNBytes(3));
                default -> out.writeInt(in.readInt());
            }
        }
        in.transferTo(out);
        return result.toByteArray();
    }

    private static Path compileStandIns(Path jar, Path work) throws IOException {
        Path sources = Files.createDirectories(work.resolve("sources"));
        Path classes = Files.createDirectories(work.resolve("classes"));
        List<String> arguments = new ArrayList<>(List.of("--release", "17", "-nowarn", "-proc:none", "-d", classes.toString(),
            "-classpath", jar + File.pathSeparator + jar.resolveSibling("groovy-" + GROOVY + ".jar")));
        for (var standIn : STAND_INS.entrySet()) {
            arguments.add(Files.writeString(sources.resolve(standIn.getKey() + ".java"), standIn.getValue()).toString());
        }
        if (ToolProvider.getSystemJavaCompiler().run(null, null, null, arguments.toArray(String[]::new)) != 0) {
            throw new IOException("the Java compiler rejects the stand-ins, see above");
        }
        return classes;
    }

    private static List<Path> files(Path folder) throws IOException {
        try (Stream<Path> paths = Files.walk(folder)) {
            return paths.filter(Files::isRegularFile).toList();
        }
    }

    private static void deleteTree(Path folder) throws IOException {
        if (Files.exists(folder)) {
            List<Path> deepestFirst;
            try (Stream<Path> paths = Files.walk(folder)) {
                deepestFirst = paths.sorted(Comparator.reverseOrder()).toList();
            }
            for (Path path : deepestFirst) {
                Files.delete(path);
            }
        }
    }

    private static String sha256(Path file) throws IOException {
        MessageDigest digest = digest("SHA-256");
        try (InputStream in = new DigestInputStream(Files.newInputStream(file), digest)) {
            in.transferTo(OutputStream.nullOutputStream());
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    private static MessageDigest digest(String algorithm) {
        try {
            return MessageDigest.getInstance(algorithm);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has " + algorithm, e);
        }
    }

    private static Part kotlin(String name, String sha256) {
        return new Part("org.jetbrains.kotlin", name, KOTLIN, sha256);
    }

    private static Part groovy(String name, String sha256) {
        return new Part("org.codehaus.groovy", name, GROOVY, sha256);
    }

    private record Part(String group, String name, String version, String sha256) {
        String fileName() {
            return name + "-" + version + ".jar";
        }

        /** Returns the Maven dependency, without transitive ones: only files with a known SHA-256 are allowed. */
        String dependency() {
            return """
                    <dependency>
                      <groupId>%s</groupId>
                      <artifactId>%s</artifactId>
                      <version>%s</version>
                      <exclusions><exclusion><groupId>*</groupId><artifactId>*</artifactId></exclusion></exclusions>
                    </dependency>
                """.formatted(group, name, version);
        }
    }

    /** Classes that gradle-api lacks, or replacements for its own. */
    private static final Map<String, String> STAND_INS = Map.of(
        // Gradle loads the reader of .gradle.kts files by this name. Here it is the reader of .gradle files.
        "KotlinScriptPluginFactory", """
            package org.gradle.kotlin.dsl.provider;

            import javax.inject.Inject;
            import org.gradle.configuration.CompileOperationFactory;
            import org.gradle.configuration.DefaultScriptPluginFactory;
            import org.gradle.groovy.scripts.ScriptCompilerFactory;
            import org.gradle.internal.Factory;
            import org.gradle.internal.logging.LoggingManagerInternal;
            import org.gradle.internal.service.ServiceRegistry;
            import org.gradle.plugin.management.internal.autoapply.AutoAppliedPluginHandler;
            import org.gradle.plugin.use.internal.PluginRequestApplicator;

            public class KotlinScriptPluginFactory extends DefaultScriptPluginFactory {
                @Inject
                public KotlinScriptPluginFactory(
                    ServiceRegistry services, ScriptCompilerFactory compilers, Factory<LoggingManagerInternal> logging,
                    AutoAppliedPluginHandler autoApplied, PluginRequestApplicator plugins, CompileOperationFactory operations
                ) {
                    super(services, compilers, logging, autoApplied, plugins, operations);
                    setScriptPluginFactory(this);
                }
            }
            """,
        // The Kotlin DSL lets plugins see Gradle's own kotlin packages; Kotlin's plugin counts on it.
        "KotlinStdlibApi", """
            package org.gradle.kotlin.dsl.provider;

            import java.util.Collections;
            import java.util.Set;
            import org.gradle.initialization.GradleApiSpecProvider;

            public class KotlinStdlibApi extends GradleApiSpecProvider.SpecAdapter implements GradleApiSpecProvider {
                public Spec get() {
                    return this;
                }

                public Set<String> getExportedPackages() {
                    return Collections.singleton("kotlin");
                }
            }
            """,
        // Gradle looks for each of its modules and libraries in a jar of its own. Here every module is all jars.
        "DefaultModuleRegistry", """
            package org.gradle.api.internal.classpath;

            import java.io.File;
            import java.util.Arrays;
            import java.util.List;
            import java.util.Set;
            import org.gradle.cache.GlobalCache;
            import org.gradle.internal.classpath.ClassPath;
            import org.gradle.internal.classpath.DefaultClassPath;
            import org.gradle.internal.installation.GradleInstallation;

            public class DefaultModuleRegistry implements ModuleRegistry, GlobalCache {
                private final GradleInstallation installation;

                public DefaultModuleRegistry(GradleInstallation installation) {
                    this.installation = installation;
                }

                public DefaultModuleRegistry(ClassPath additional, GradleInstallation installation) {
                    this(installation);
                }

                public Module getModule(String name) {
                    return new Jars(".*jar");
                }

                public Module findModule(String name) {
                    return getModule(name);
                }

                public Module getExternalModule(String name) {
                    return new Jars(name + "-[0-9].*");
                }

                public ClassPath getAdditionalClassPath() {
                    return ClassPath.EMPTY;
                }

                public List<File> getGlobalCacheRoots() {
                    return installation.getLibDirs();
                }

                private class Jars implements Module {
                    private final ClassPath classPath;

                    Jars(String name) {
                        File lib = new File(installation.getGradleHome(), "lib");
                        File[] jars = lib.listFiles(file -> file.getName().matches(name));
                        Arrays.sort(jars);
                        classPath = DefaultClassPath.of(jars);
                    }

                    public ClassPath getImplementationClasspath() {
                        return classPath;
                    }

                    public ClassPath getRuntimeClasspath() {
                        return ClassPath.EMPTY;
                    }

                    public ClassPath getClasspath() {
                        return classPath;
                    }

                    public Set<Module> getRequiredModules() {
                        return Set.of();
                    }

                    public Set<Module> getAllRequiredModules() {
                        return Set.of(this);
                    }

                    public ClassPath getAllRequiredModulesClasspath() {
                        return classPath;
                    }
                }
            }
            """);
}
