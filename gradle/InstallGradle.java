import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.math.BigInteger;
import java.net.HttpURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;

/**
 * Puts Gradle 8.7 together from Maven Central, for machines that cannot reach Gradle's own distribution server.
 *
 * <p>When it runs: gradlew and gradlew.bat start it while the Gradle that gradle/wrapper/gradle-wrapper.properties asks for
 * is not installed. It can be run by hand too: {@code java gradle/InstallGradle.java}. It needs a JDK 17 or newer and, if it
 * has something to install, Maven ({@code mvn}) on the PATH; whatever mirrors and proxies Maven is set up with apply.
 *
 * <p>What it does: nothing, silently, if Gradle is installed, or if the ordinary wrapper can download it. Otherwise it
 * fetches {@code dev.gradleplugins:gradle-api} and a few libraries through Maven, compares each with its SHA-256 below,
 * builds a Gradle home out of them, and moves it to where the wrapper expects it, with the marker file the wrapper would
 * leave. From then on the unchanged wrapper starts it.
 *
 * <p>How a jar becomes a Gradle home: gradle-api holds every class of Gradle in one jar, but with third-party packages moved
 * below {@code org.gradle.internal.impldep}, and without the Kotlin DSL. {@link Unshading} moves the packages back,
 * {@link Distribution} lays the jars out as Gradle expects them, and {@link Shims} stand in for what is missing. So a
 * {@code settings.gradle.kts} is read by Groovy here, and has to be valid Kotlin and valid Groovy.
 *
 * <p>Exit code 0: Gradle is there, or the wrapper can get it. Exit code 1: it is not; the reason is on standard error.
 *
 * <p>This file is plain ASCII on purpose: before JDK 18 the launcher reads it in the platform's own encoding.
 */
public final class InstallGradle {
    private static final String VERSION = "8.7";
    private static final String DISTRIBUTION = "gradle-" + VERSION + "-bin.zip";

    /** The versions of these that Gradle 8.7 itself comes with; {@code gradle --version} prints them. */
    private static final String KOTLIN = "1.9.22";
    private static final String GROOVY = "3.0.17";
    private static final String ANT = "1.10.13";

    private static final Artifact GRADLE_API = new Artifact("dev.gradleplugins", "gradle-api", VERSION,
        "3977770bbfdf27e04c5a136810c092aa88841c63c44cb954b0135dd875ca9cc8");

    /** Everything that is downloaded. New hashes: {@code java gradle/InstallGradle.java --print-hashes}. */
    private static final List<Artifact> ARTIFACTS = List.of(
        GRADLE_API,
        kotlin("kotlin-stdlib", "6abe146c27864138b874ccccfe5f534e3eb923c99a1b7b5d45494ee5694f3e0a"),
        kotlin("kotlin-reflect", "77f311ca1384811d519fda389fcb1268bdaa058d605046e0ede76c03b0df3e97"),
        ant("ant", "befbfc79e744e9892cfa7db96df3b6e82dc17d2571af42aa427976fc22299838"),
        ant("ant-junit", "017c9b6bafdfaf73b070933c9f4034a34a38c3b34bdd1167e29356d47eaeed03"),
        ant("ant-launcher", "cd7695b3bfb6964ab71b6a0b31dad60005ae77fe502132364679aacf08f77970"),
        groovy("groovy", "9ed2a565a8592a9f63f410afed892d0ca6bec1ff96277ce4cc7f3e2e366e794f"),
        groovy("groovy-ant", "baf25567b0a5c7e13fe57a48d1f7458cafb33bed8e4f0aefa1874491f8291c51"),
        groovy("groovy-astbuilder", "372fb74dfea9cb4f5bf32f31b9d12314705777745ec915333d18a5b14b37923b"),
        groovy("groovy-console", "448f34031e95485cc2b326e6cb47f2d8a89e009c45833ceebc00958658eff108"),
        groovy("groovy-datetime", "98f2889a3f133e2c5a502722732e488366599578e5dbd56dcdcaf5e0790c9d7e"),
        groovy("groovy-dateutil", "346211305926421a99725c6ca148288abc76181164c5a03c5063b80906fb62fd"),
        groovy("groovy-docgenerator", "2383575ffa9cf4f30b3a45038d5b6c6e954804620046656fff5614c0186aeac4"),
        groovy("groovy-groovydoc", "85056d2f835954929564aa4295e73d310a54622b720346d8068f07a2ae9a5f1d"),
        groovy("groovy-json", "f577bd1551570162d42f22373ff164894ebf2f295d72d8ee914866aaa2ac37d4"),
        groovy("groovy-nio", "d06180fc0f591bf7c62818a653d8e128533bc1ef2604463ffb73c7e962486ae8"),
        groovy("groovy-sql", "b78710a77fb7c7973d613448db99a08d2f880e040e82981900fb645f726bfe31"),
        groovy("groovy-swing", "a8a022a42d0b1ca21624e76a554a1a99d4b3ab6487b9450fd03265ffc760da32"),
        groovy("groovy-templates", "64aea1cad62685bbf71d4a69ca5b21ff1b50d4bb364b0c1308170e6f3ad317a3"),
        groovy("groovy-test", "8073ffe1fc574c3ddd45e100eac125fe64e2be35e204909ec1f3f1d28627b396"),
        groovy("groovy-xml", "52fc4047a3dcb870b05ad73f6b1dcebb5a0ae97b5a58f58b581f8960ab128ab1"));

    private static final String START_MESSAGE = "Gradle's server cannot be reached: putting Gradle " + VERSION
        + " together from Maven Central instead (once, about 200 MB, half a minute or more)...";

    private InstallGradle() {
    }

    public static void main(String[] args) {
        try {
            if (List.of(args).equals(List.of("--print-hashes"))) {
                printHashes();
            } else {
                installIfNeeded(args);
            }
        } catch (Failure e) {
            exit(e.getMessage());
        } catch (IOException | UncheckedIOException e) {
            exit("Gradle " + VERSION + " could not be installed: " + reason(e) + ".");
        } catch (InterruptedException e) {
            exit("Installing Gradle " + VERSION + " was interrupted.");
        }
    }

    private static void exit(String message) {
        System.err.println(message);
        System.exit(1);
    }

    private static void installIfNeeded(String[] args) throws IOException, InterruptedException, Failure {
        Path project = projectFolder();
        CommandLine commandLine = CommandLine.parse(args);
        commandLine.setSystemProperties();
        File userHome = commandLine.gradleUserHome();
        setSystemPropertiesFrom(userHome.toPath().resolve("gradle.properties"));
        setSystemPropertiesFrom(project.resolve("gradle.properties"));

        Wrapper wrapper = Wrapper.read(project, userHome);
        if (wrapper.isInstalled() || wrapper.canInstall()) {
            return;
        }
        if (!wrapper.zip().getFileName().toString().equals(DISTRIBUTION)) {
            throw new Failure("Gradle cannot be downloaded from " + wrapper.url() + ", and gradle/InstallGradle.java can"
                + " stand in for " + DISTRIBUTION + " only: give this machine access to that address, or ask for "
                + DISTRIBUTION + " in gradle/wrapper/gradle-wrapper.properties.");
        }
        try {
            new Installation(wrapper).run();
        } catch (IOException | UncheckedIOException e) {
            throw wrapper.failure(reason(e));
        }
    }

    /** Prints the lines of {@link #ARTIFACTS} that must change, too, when the versions above do. */
    private static void printHashes() throws IOException, InterruptedException, Failure {
        Path folder = Files.createTempDirectory("gradle-hashes");
        try {
            new Maven(folder).fetch(ARTIFACTS);
            for (Artifact artifact : ARTIFACTS) {
                System.out.println(artifact + " " + sha256(folder.resolve(artifact.fileName())));
            }
        } catch (MavenFailure e) {
            throw new Failure(e.getMessage() + e.output());
        } finally {
            deleteTree(folder);
        }
    }

    /** The folder above the one this source file lies in, whatever the current folder is. */
    private static Path projectFolder() throws Failure {
        try {
            URI source = InstallGradle.class.getProtectionDomain().getCodeSource().getLocation().toURI();
            return Path.of(source).getParent().getParent();
        } catch (URISyntaxException | RuntimeException e) {
            throw new Failure("The project's folder cannot be found; run this program as: java gradle/InstallGradle.java");
        }
    }

    /** The wrapper takes proxies and the like from {@code systemProp.} lines of these files; so does the check here. */
    private static void setSystemPropertiesFrom(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            return;
        }
        String prefix = "systemProp.";
        Properties properties = loadProperties(Files.readAllBytes(file));
        for (String name : properties.stringPropertyNames()) {
            if (name.startsWith(prefix) && name.length() > prefix.length()) {
                System.setProperty(name.substring(prefix.length()), properties.getProperty(name));
            }
        }
    }

    /** A failure that is reported to the user: one understandable sentence, no stack trace. */
    private static class Failure extends Exception {
        Failure(String message) {
            super(message);
        }
    }

    // ---------------------------------------------------------------------------------------------------------------------
    // What the wrapper does
    // ---------------------------------------------------------------------------------------------------------------------

    /** Those of Gradle's options that decide where the wrapper looks for Gradle. */
    private record CommandLine(List<String> systemProperties, String userHomeOption) {
        private static final Pattern JVM_OPTION = Pattern.compile("(?:\"[^\"]*\"|'[^']*'|[^\\s\"'])+");

        /** Like the wrapper, reads options up to the first argument that is not one. */
        static CommandLine parse(String[] args) {
            List<String> properties = new ArrayList<>(jvmSystemProperties("JAVA_OPTS"));
            properties.addAll(jvmSystemProperties("GRADLE_OPTS"));
            String userHome = null;
            for (int i = 0; i < args.length && args[i].startsWith("-") && !args[i].equals("--"); i++) {
                String next = i + 1 < args.length ? args[i + 1] : null;
                String arg = args[i];
                if (List.of("-g", "--gradle-user-home").contains(arg)) {
                    userHome = next;
                    i++;
                } else if (arg.startsWith("--gradle-user-home=")) {
                    userHome = arg.substring("--gradle-user-home=".length());
                } else if (arg.startsWith("-g")) {
                    userHome = arg.substring(arg.startsWith("-g=") ? 3 : 2);
                } else if (List.of("-D", "--system-prop").contains(arg) && next != null) {
                    properties.add(next);
                    i++;
                } else if (arg.startsWith("--system-prop=")) {
                    properties.add(arg.substring("--system-prop=".length()));
                } else if (arg.startsWith("-D")) {
                    properties.add(arg.substring(2));
                }
            }
            return new CommandLine(properties, userHome);
        }

        /** gradlew hands these variables to the wrapper's JVM, not to this one. */
        private static List<String> jvmSystemProperties(String variable) {
            String options = System.getenv().getOrDefault(variable, "");
            return JVM_OPTION.matcher(options).results()
                .map(MatchResult::group)
                .map(option -> option.replaceAll("[\"']", ""))
                .filter(option -> option.startsWith("-D"))
                .map(option -> option.substring(2))
                .toList();
        }

        void setSystemProperties() {
            for (String property : systemProperties) {
                String[] nameAndValue = property.split("=", 2);
                if (!nameAndValue[0].isEmpty()) {
                    System.setProperty(nameAndValue[0], nameAndValue.length == 2 ? nameAndValue[1] : "");
                }
            }
        }

        File gradleUserHome() {
            String environment = System.getenv("GRADLE_USER_HOME");
            if (userHomeOption != null) {
                return new File(userHomeOption);
            } else if (System.getProperty("gradle.user.home") != null) {
                return new File(System.getProperty("gradle.user.home"));
            } else if (environment != null) {
                return new File(environment);
            }
            return new File(System.getProperty("user.home"), ".gradle");
        }
    }

    /**
     * What gradle-wrapper.properties asks for, and where the wrapper keeps it.
     *
     * @param url where the wrapper downloads it
     * @param folder where the wrapper unpacks it: the one folder in there is the Gradle home
     * @param zip where the wrapper stores the download; its marker and its lock lie beside it
     */
    private record Wrapper(URI url, Path folder, Path zip) {
        private static final int TIMEOUT_MILLIS = 5_000;

        static Wrapper read(Path project, File userHome) throws IOException, Failure {
            Path file = project.resolve("gradle").resolve("wrapper").resolve("gradle-wrapper.properties");
            if (!Files.isRegularFile(file)) {
                throw new Failure("There is no " + file + "; restore it from the repository.");
            }
            Properties properties = loadProperties(Files.readAllBytes(file));
            URI url = distributionUrl(properties, file);

            String zipName = url.getPath().substring(url.getPath().lastIndexOf('/') + 1);
            String name = zipName.contains(".") ? zipName.substring(0, zipName.lastIndexOf('.')) : zipName;
            String path = name + "/" + hash(url);
            Path folder = location(properties, "distribution", project, userHome).resolve(path);
            Path zip = location(properties, "zipStore", project, userHome).resolve(path).resolve(zipName);
            return new Wrapper(url, folder, zip);
        }

        /** A URL without a scheme is the path of a file, relative to the folder of the properties. */
        private static URI distributionUrl(Properties properties, Path file) throws Failure {
            try {
                URI url = new URI(properties.getProperty("distributionUrl", "").trim());
                if (url.getPath() == null || url.getPath().isEmpty()) {
                    throw new Failure("There is no usable distributionUrl in " + file + "; restore it from the repository.");
                }
                return url.getScheme() == null ? new File(file.getParent().toFile(), url.getPath()).toURI() : url;
            } catch (URISyntaxException e) {
                throw new Failure("The distributionUrl in " + file + " is not a URL; restore it from the repository.");
            }
        }

        private static Path location(Properties properties, String kind, Path project, File userHome) throws Failure {
            String base = properties.getProperty(kind + "Base", "GRADLE_USER_HOME");
            String path = properties.getProperty(kind + "Path", "wrapper/dists");
            // File, not Path: both resolve an empty user home differently, and the wrapper uses File.
            return switch (base) {
                case "GRADLE_USER_HOME" -> new File(userHome, path).toPath().toAbsolutePath();
                case "PROJECT" -> new File(project.toFile(), path).toPath().toAbsolutePath();
                default -> throw new Failure("gradle-wrapper.properties has " + kind + "Base=" + base
                    + "; it has to be GRADLE_USER_HOME or PROJECT.");
            };
        }

        /** The wrapper leaves out user and password, so that they do not show in a folder's name. */
        private static String hash(URI url) throws Failure {
            try {
                URI safe = new URI(url.getScheme(), null, url.getHost(), url.getPort(), url.getPath(), url.getQuery(),
                    url.getFragment());
                byte[] digest = digest("MD5").digest(safe.toASCIIString().getBytes(StandardCharsets.UTF_8));
                return new BigInteger(1, digest).toString(36);
            } catch (URISyntaxException e) {
                throw new Failure("The distributionUrl in gradle-wrapper.properties is not a URL: " + e.getMessage());
            }
        }

        Path marker() {
            return zip.resolveSibling(zip.getFileName() + ".ok");
        }

        Path lock() {
            return zip.resolveSibling(zip.getFileName() + ".lck");
        }

        /** The same test as the wrapper's: marker, and exactly one folder, which holds a launcher. */
        boolean isInstalled() throws IOException {
            if (!Files.isRegularFile(marker()) || !Files.isDirectory(folder)) {
                return false;
            }
            List<Path> homes = subfolders(folder);
            return homes.size() == 1 && hasLauncher(homes.get(0).resolve("lib"));
        }

        private static boolean hasLauncher(Path lib) throws IOException {
            if (!Files.isDirectory(lib)) {
                return false;
            }
            try (Stream<Path> jars = Files.list(lib)) {
                return jars.anyMatch(jar -> jar.getFileName().toString().matches("gradle-launcher-.*\\.jar"));
            }
        }

        /** Whether the zip is here already, or can be had from its server. */
        boolean canInstall() {
            boolean remote = List.of("http", "https").contains(url.getScheme());
            return Files.isRegularFile(zip) || !remote || serverAnswers();
        }

        private boolean serverAnswers() {
            try {
                HttpURLConnection connection = (HttpURLConnection) url.toURL().openConnection();
                connection.setRequestMethod("HEAD");
                connection.setConnectTimeout(TIMEOUT_MILLIS);
                connection.setReadTimeout(TIMEOUT_MILLIS);
                int status = connection.getResponseCode();
                connection.disconnect();
                // The wrapper may have the credentials that this request lacks.
                boolean needsCredentials = status == HttpURLConnection.HTTP_UNAUTHORIZED
                    || status == HttpURLConnection.HTTP_PROXY_AUTH;
                return status == HttpURLConnection.HTTP_OK || needsCredentials;
            } catch (IOException | IllegalArgumentException e) {
                return false;
            }
        }

        Failure failure(String reason) {
            return new Failure("Gradle " + VERSION + " could not be installed: " + reason + ". Fix that, or give this"
                + " machine access to " + url + ", or put the file from there into " + zip.getParent() + ".");
        }
    }

    // ---------------------------------------------------------------------------------------------------------------------
    // Installing: all or nothing, one at a time
    // ---------------------------------------------------------------------------------------------------------------------

    /** Builds Gradle in a folder beside the final one, and moves it into place when it is complete. */
    private static final class Installation {
        private final Wrapper wrapper;
        /** In the same parent folder, so on the same disk: the move is one step. A fixed name: leftovers get found. */
        private final Path work;
        private final Maven maven;

        Installation(Wrapper wrapper) {
            this.wrapper = wrapper;
            this.work = wrapper.folder().resolveSibling(wrapper.folder().getFileName() + ".partial");
            this.maven = new Maven(work.resolve("jars"));
        }

        /** Holds the wrapper's own lock: a second run, or a wrapper an IDE starts, waits for this one. */
        void run() throws IOException, InterruptedException, Failure {
            JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
            if (compiler == null) {
                throw wrapper.failure("this Java has no compiler; a JDK 17 or newer is needed");
            }
            Files.createDirectories(wrapper.zip().getParent());
            try (FileChannel file = FileChannel.open(wrapper.lock(), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
                 FileLock lock = waitForLock(file)) {
                if (!wrapper.isInstalled()) {
                    buildAndMove(compiler);
                }
            }
        }

        private static FileLock waitForLock(FileChannel file) throws IOException {
            FileLock lock = file.tryLock();
            if (lock != null) {
                return lock;
            }
            System.err.println("Waiting for another process that installs Gradle " + VERSION + "...");
            return file.lock();
        }

        private void buildAndMove(JavaCompiler compiler) throws IOException, InterruptedException, Failure {
            System.err.println(START_MESSAGE);
            Thread onKill = new Thread(this::cleanUp);
            Runtime.getRuntime().addShutdownHook(onKill);
            try {
                deleteTree(work);
                Path home = build(compiler);
                moveIntoPlace(home);
            } catch (MavenFailure e) {
                throw new Failure(wrapper.failure(e.getMessage()).getMessage() + e.output());
            } finally {
                retire(onKill);
                deleteTree(work);
            }
        }

        private Path build(JavaCompiler compiler) throws IOException, InterruptedException, Failure {
            Path jars = Files.createDirectories(work.resolve("jars"));
            maven.fetch(ARTIFACTS);
            for (Artifact artifact : ARTIFACTS) {
                verify(artifact, jars.resolve(artifact.fileName()));
            }
            Path home = work.resolve("gradle-" + VERSION);
            new Distribution(jars, home, new Shims(compiler, work.resolve("shims"))).build();
            return home;
        }

        private void verify(Artifact artifact, Path jar) throws IOException, Failure {
            String actual = sha256(jar);
            if (!actual.equals(artifact.sha256())) {
                throw wrapper.failure("what Maven gives for " + artifact + " is not the expected file (SHA-256 expected "
                    + artifact.sha256() + ", actual " + actual + "); delete it from Maven's local repository, or ask whoever"
                    + " runs the mirror it came from");
            }
        }

        /** The marker comes last: without it, the wrapper and this program take the folder for not installed. */
        private void moveIntoPlace(Path home) throws IOException {
            Files.deleteIfExists(wrapper.marker());
            Files.createDirectories(wrapper.folder());
            for (Path broken : subfolders(wrapper.folder())) {
                deleteTree(broken);
            }
            Files.move(home, wrapper.folder().resolve(home.getFileName()), StandardCopyOption.ATOMIC_MOVE);
            Files.createFile(wrapper.marker());
        }

        /** Runs when the process is told to stop. The main thread may still be writing: hence more than one attempt. */
        private void cleanUp() {
            maven.stop();
            for (int attempt = 0; attempt < 20 && Files.exists(work); attempt++) {
                try {
                    deleteTree(work);
                    Thread.sleep(50);
                } catch (IOException e) {
                    // Something was written meanwhile: try again. What stays is deleted by the next run.
                } catch (InterruptedException e) {
                    return;
                }
            }
        }

        /** Must not let go of the lock while the hook still deletes: a second run could be using the folder by then. */
        private static void retire(Thread hook) throws InterruptedException {
            try {
                Runtime.getRuntime().removeShutdownHook(hook);
            } catch (IllegalStateException shuttingDown) {
                Thread.sleep(Long.MAX_VALUE);
            }
        }
    }

    // ---------------------------------------------------------------------------------------------------------------------
    // Downloading
    // ---------------------------------------------------------------------------------------------------------------------

    private record Artifact(String group, String name, String version, String sha256) {
        String fileName() {
            return name + "-" + version + ".jar";
        }

        @Override
        public String toString() {
            return group + ":" + name + ":" + version;
        }
    }

    private static Artifact kotlin(String name, String sha256) {
        return new Artifact("org.jetbrains.kotlin", name, KOTLIN, sha256);
    }

    private static Artifact ant(String name, String sha256) {
        return new Artifact("org.apache.ant", name, ANT, sha256);
    }

    private static Artifact groovy(String name, String sha256) {
        return new Artifact("org.codehaus.groovy", name, GROOVY, sha256);
    }

    private static final class MavenFailure extends Failure {
        private final List<String> lastLines;

        MavenFailure(String message, List<String> lastLines) {
            super(message);
            this.lastLines = lastLines;
        }

        String output() {
            return lastLines.isEmpty() ? "" : "\nMaven's last lines:\n  " + String.join("\n  ", lastLines);
        }
    }

    /** The machine's own Maven, so that its mirrors, proxies and local repository apply. */
    private static final class Maven {
        private static final String COPY = "org.apache.maven.plugins:maven-dependency-plugin:3.6.1:copy-dependencies";
        private static final int LAST_LINES = 10;
        private static final Pattern ESCAPE_SEQUENCE = Pattern.compile("\u001B\\[[0-9;]*m");

        private final Path folder;
        private volatile Process process;

        Maven(Path folder) {
            this.folder = folder;
        }

        /** Runs in the folder, with relative paths only: no path has to survive a Windows command line. */
        void fetch(List<Artifact> artifacts) throws IOException, InterruptedException, MavenFailure {
            Files.writeString(folder.resolve("pom.xml"), pom(artifacts));
            process = start();
            process.getOutputStream().close();
            List<String> lastLines = lastLines(process.getInputStream());
            int exitCode = process.waitFor();
            if (exitCode != 0) {
                throw new MavenFailure("Maven failed with exit code " + exitCode, lastLines);
            }
            for (Artifact artifact : artifacts) {
                if (!Files.isRegularFile(folder.resolve(artifact.fileName()))) {
                    throw new MavenFailure("Maven did not deliver " + artifact, lastLines);
                }
            }
        }

        private Process start() throws MavenFailure {
            String mvn = File.separatorChar == '\\' ? "mvn.cmd" : "mvn";
            try {
                return new ProcessBuilder(mvn, "-q", "-B", COPY, "-DoutputDirectory=.")
                    .directory(folder.toFile())
                    .redirectErrorStream(true)
                    .start();
            } catch (IOException e) {
                throw new MavenFailure("Maven (" + mvn + ") is not on the PATH; install Maven 3.6 or newer", List.of());
            }
        }

        private static List<String> lastLines(InputStream output) throws IOException {
            Deque<String> lines = new ArrayDeque<>();
            try (var reader = new BufferedReader(new InputStreamReader(output, Charset.defaultCharset()))) {
                for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                    String text = ESCAPE_SEQUENCE.matcher(line).replaceAll("").strip();
                    if (!text.isEmpty() && !text.equals("[ERROR]")) {
                        lines.addLast(text);
                    }
                    if (lines.size() > LAST_LINES) {
                        lines.removeFirst();
                    }
                }
            }
            return List.copyOf(lines);
        }

        /** On Windows the process is a script, and Maven its child. */
        void stop() {
            Process running = process;
            if (running != null) {
                running.descendants().forEach(ProcessHandle::destroy);
                running.destroy();
            }
        }

        /** Without transitive dependencies: only files with a pinned hash are wanted. */
        private static String pom(List<Artifact> artifacts) {
            return """
                <project>
                  <modelVersion>4.0.0</modelVersion>
                  <groupId>none</groupId>
                  <artifactId>gradle-parts</artifactId>
                  <version>1</version>
                  <dependencies>
                %s  </dependencies>
                </project>
                """.formatted(artifacts.stream().map(Maven::dependency).collect(Collectors.joining()));
        }

        private static String dependency(Artifact artifact) {
            return """
                    <dependency>
                      <groupId>%s</groupId>
                      <artifactId>%s</artifactId>
                      <version>%s</version>
                      <exclusions><exclusion><groupId>*</groupId><artifactId>*</artifactId></exclusion></exclusions>
                    </dependency>
                """.formatted(artifact.group(), artifact.name(), artifact.version());
        }
    }

    // ---------------------------------------------------------------------------------------------------------------------
    // Building the Gradle home
    // ---------------------------------------------------------------------------------------------------------------------

    /**
     * Lays out a Gradle home.
     *
     * <p>Gradle finds its modules by jar name, {@code <module>-8.7.jar}, and reads in each jar a
     * {@code <module>-classpath.properties} which says what other jars it needs. Here all classes are in one jar, that of
     * gradle-core-api: generated version-catalog accessors are compiled against exactly that jar. Every other module is a
     * stub without classes that names it.
     */
    private static final class Distribution {
        private static final String CORE_MODULE = "gradle-core-api";
        private static final String CORE_JAR = jarName(CORE_MODULE);
        private static final String GROOVY_JAR = "groovy-" + GROOVY + ".jar";
        private static final String KOTLIN_STDLIB_JAR = "kotlin-stdlib-" + KOTLIN + ".jar";
        private static final String KOTLIN_REFLECT_JAR = "kotlin-reflect-" + KOTLIN + ".jar";

        private static final String CLASSPATH_SUFFIX = "-classpath.properties";
        private static final String SERVICES = "META-INF/services/";
        private static final String MANIFEST = "META-INF/MANIFEST.MF";
        private static final String MANIFEST_START = "Manifest-Version: 1.0\n";

        /** Modules Gradle asks for by name, although gradle-api has nothing of them. */
        private static final List<String> MISSING_MODULES = List.of("gradle-installation-beacon", "gradle-api-metadata",
            "gradle-build-profile", "gradle-java-compiler-plugin", "gradle-test-kit");

        /** These list the modules that are in lib/plugins. */
        private static final List<String> PLUGIN_LISTS = List.of("gradle-plugins.properties",
            "gradle-implementation-plugins.properties");

        private final Path jars;
        private final Path home;
        private final Path lib;
        private final Shims shims;
        private final Map<String, Properties> modules = new TreeMap<>();
        private final Set<String> pluginModules = new HashSet<>();
        private final Map<String, Set<String>> services = new TreeMap<>();

        Distribution(Path jars, Path home, Shims shims) {
            this.jars = jars;
            this.home = home;
            this.lib = home.resolve("lib");
            this.shims = shims;
        }

        void build() throws IOException, Failure {
            Files.createDirectories(lib.resolve("plugins"));
            Files.createDirectories(lib.resolve("agents"));
            moveLibraries();
            shims.compile(List.of(jars.resolve(GRADLE_API.fileName()), lib.resolve(GROOVY_JAR)));
            writeCoreJar();
            writeModuleStubs();
            writeLibraryStubs();
            writeAgent();
        }

        private void moveLibraries() throws IOException {
            for (Artifact artifact : ARTIFACTS) {
                if (artifact != GRADLE_API) {
                    Files.move(jars.resolve(artifact.fileName()), lib.resolve(artifact.fileName()));
                }
            }
        }

        private void writeCoreJar() throws IOException {
            Set<String> written = new HashSet<>();
            try (ZipFile api = new ZipFile(jars.resolve(GRADLE_API.fileName()).toFile());
                 ZipOutputStream core = newJar(CORE_JAR)) {
                for (ZipEntry entry : Collections.list(api.entries())) {
                    if (!entry.isDirectory() && !isDropped(entry.getName())) {
                        convert(entry.getName(), api.getInputStream(entry).readAllBytes(), core, written);
                    }
                }
                addService("org.gradle.initialization.GradleApiSpecProvider", Shims.STDLIB_API);
                for (var service : services.entrySet()) {
                    put(core, SERVICES + service.getKey(), String.join("\n", service.getValue()));
                }
                for (String shim : List.of(Shims.SCRIPT_FACTORY, Shims.STDLIB_API)) {
                    put(core, Shims.fileName(shim), shims.classFile(shim));
                }
                put(core, CORE_MODULE + CLASSPATH_SUFFIX, classpathProperties(CORE_MODULE, false));
                put(core, "gradle-kotlin-dsl-versions.properties", "kotlin=" + KOTLIN + "\n");
            }
        }

        /**
         * The marker and the index are true of gradle-api only. Services of the JDK itself (such as character sets) would be
         * looked up by the daemon's JVM while it starts, and stop it.
         */
        private static boolean isDropped(String name) {
            return name.equals("META-INF/.gradle-runtime-shaded")
                || name.equals("META-INF/INDEX.LIST")
                || name.startsWith(SERVICES + "java");
        }

        private void convert(String name, byte[] content, ZipOutputStream core, Set<String> written) throws IOException {
            String newName = Unshading.text(name);
            if (name.endsWith(CLASSPATH_SUFFIX)) {
                modules.put(name.substring(0, name.length() - CLASSPATH_SUFFIX.length()), loadProperties(content));
            } else if (newName.startsWith(SERVICES)) {
                String text = Unshading.text(new String(content, StandardCharsets.UTF_8));
                text.lines().map(String::strip).forEach(line -> addService(newName.substring(SERVICES.length()), line));
            } else if (written.add(newName)) {
                if (PLUGIN_LISTS.contains(name)) {
                    pluginModules.addAll(list(loadProperties(content), "plugins"));
                }
                put(core, newName, name.endsWith(".class") ? Unshading.classFile(content) : content);
            }
        }

        private void addService(String type, String implementation) {
            services.computeIfAbsent(type, key -> new LinkedHashSet<>()).add(implementation);
        }

        private void writeModuleStubs() throws IOException {
            MISSING_MODULES.forEach(module -> modules.putIfAbsent(module, new Properties()));
            for (String module : modules.keySet()) {
                if (!module.equals(CORE_MODULE)) {
                    writeModuleStub(module);
                }
            }
        }

        private void writeModuleStub(String module) throws IOException {
            String folder = pluginModules.contains(module) ? "plugins/" : "";
            try (ZipOutputStream jar = newJar(folder + jarName(module))) {
                if (module.equals("gradle-launcher")) {
                    // The wrapper loads the launcher's jar alone; what its manifest names is loaded with it.
                    put(jar, MANIFEST, MANIFEST_START
                        + "Class-Path: " + CORE_JAR + "\n  " + GROOVY_JAR + "\n  " + KOTLIN_STDLIB_JAR + "\n");
                }
                put(jar, module + CLASSPATH_SUFFIX, classpathProperties(module, module.equals("gradle-core")));
            }
        }

        private String classpathProperties(String module, boolean withKotlin) {
            Properties original = modules.get(module);
            Set<String> runtime = new LinkedHashSet<>(list(original, "runtime"));
            runtime.add(CORE_JAR);
            if (withKotlin) {
                runtime.add(KOTLIN_STDLIB_JAR);
                runtime.add(KOTLIN_REFLECT_JAR);
            }
            return "projects=" + original.getProperty("projects", "") + "\nruntime=" + String.join(",", runtime) + "\n";
        }

        /** Gradle insists on every third-party jar that its modules name; their classes are in the core jar. */
        private void writeLibraryStubs() throws IOException {
            Set<String> names = new TreeSet<>();
            modules.values().forEach(module -> names.addAll(list(module, "runtime")));
            for (String name : names) {
                if (Files.notExists(lib.resolve(name))) {
                    try (ZipOutputStream jar = newJar(name)) {
                        put(jar, MANIFEST, MANIFEST_START);
                    }
                }
            }
        }

        /** Gradle expects the agent's jar. The properties, from which every build starts, prevent its use. */
        private void writeAgent() throws IOException {
            String module = "gradle-instrumentation-agent";
            try (ZipOutputStream jar = newJar("agents/" + jarName(module))) {
                put(jar, MANIFEST, MANIFEST_START + "Premain-Class: " + Shims.NO_AGENT + "\n");
                put(jar, module + CLASSPATH_SUFFIX, "projects=\nruntime=\n");
                put(jar, Shims.fileName(Shims.NO_AGENT), shims.classFile(Shims.NO_AGENT));
            }
            Files.writeString(home.resolve("gradle.properties"), "org.gradle.internal.instrumentation.agent=false\n");
        }

        private static String jarName(String module) {
            return module + "-" + VERSION + ".jar";
        }

        private static List<String> list(Properties properties, String key) {
            return Arrays.stream(properties.getProperty(key, "").split(",")).filter(name -> !name.isBlank()).toList();
        }

        private ZipOutputStream newJar(String name) throws IOException {
            ZipOutputStream jar = new ZipOutputStream(Files.newOutputStream(lib.resolve(name)));
            jar.setLevel(Deflater.BEST_SPEED);
            return jar;
        }

        private static void put(ZipOutputStream jar, String name, String content) throws IOException {
            put(jar, name, content.getBytes(StandardCharsets.UTF_8));
        }

        private static void put(ZipOutputStream jar, String name, byte[] content) throws IOException {
            jar.putNextEntry(new ZipEntry(name));
            jar.write(content);
            jar.closeEntry();
        }
    }

    /** Moves third-party packages back to where their authors put them. */
    private static final class Unshading {
        private static final String PREFIX = "org.gradle.internal.impldep.";
        private static final String PATH_PREFIX = PREFIX.replace('.', '/');

        static String text(String text) {
            return text.replace(PATH_PREFIX, "").replace(PREFIX, "");
        }

        /** Every name, descriptor and string of a class is a Utf8 entry of its constant pool; the rest refers to those. */
        static byte[] classFile(byte[] original) throws IOException {
            ByteArrayOutputStream result = new ByteArrayOutputStream(original.length);
            DataInputStream in = new DataInputStream(new ByteArrayInputStream(original));
            DataOutputStream out = new DataOutputStream(result);
            out.writeInt(in.readInt()); // magic number
            out.writeInt(in.readInt()); // version of the format
            int count = in.readUnsignedShort();
            out.writeShort(count);
            for (int index = 1; index < count; ) {
                index += copyConstant(in, out);
            }
            in.transferTo(out);
            return result.toByteArray();
        }

        /** Returns how many places of the constant pool the constant takes. */
        private static int copyConstant(DataInputStream in, DataOutputStream out) throws IOException {
            int tag = in.readUnsignedByte();
            out.writeByte(tag);
            switch (tag) {
                case 1 -> out.writeUTF(text(in.readUTF())); // Utf8
                case 3, 4 -> out.writeInt(in.readInt()); // Integer, Float
                case 5, 6 -> out.writeLong(in.readLong()); // Long, Double
                case 7, 8, 16, 19, 20 -> out.writeShort(in.readShort()); // Class, String, MethodType, Module, Package
                case 9, 10, 11, 12, 17, 18 -> out.writeInt(in.readInt()); // pairs of references
                case 15 -> { // MethodHandle
                    out.writeByte(in.readByte());
                    out.writeShort(in.readShort());
                }
                default -> throw new IOException("unknown constant " + tag + " in a class of " + GRADLE_API);
            }
            return tag == 5 || tag == 6 ? 2 : 1;
        }
    }

    /** Three small classes that stand in for parts gradle-api lacks. They are compiled on the spot. */
    private static final class Shims {
        private static final String PACKAGE = "org.gradle.kotlin.dsl.provider.";
        static final String SCRIPT_FACTORY = PACKAGE + "KotlinScriptPluginFactory";
        static final String STDLIB_API = PACKAGE + "KotlinStdlibApi";
        static final String NO_AGENT = PACKAGE + "NoAgent";

        private static final Map<String, String> SOURCES = Map.of(
            // Gradle loads the reader of .gradle.kts files by this name. Here it is the reader of .gradle files.
            SCRIPT_FACTORY, """
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
                        ServiceRegistry services, ScriptCompilerFactory compilers,
                        Factory<LoggingManagerInternal> logging, AutoAppliedPluginHandler autoApplied,
                        PluginRequestApplicator plugins, CompileOperationFactory operations
                    ) {
                        super(services, compilers, logging, autoApplied, plugins, operations);
                        setScriptPluginFactory(this);
                    }
                }
                """,
            // The Kotlin DSL lets plugins see Gradle's own kotlin packages; Kotlin's plugin counts on it.
            STDLIB_API, """
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
            // The instrumentation agent is not in gradle-api. This one does nothing.
            NO_AGENT, """
                package org.gradle.kotlin.dsl.provider;

                public class NoAgent {
                    public static void premain(String args, java.lang.instrument.Instrumentation instrumentation) {
                    }
                }
                """);

        private final JavaCompiler compiler;
        private final Path sources;
        private final Path classes;

        Shims(JavaCompiler compiler, Path folder) {
            this.compiler = compiler;
            this.sources = folder.resolve("sources");
            this.classes = folder.resolve("classes");
        }

        void compile(List<Path> classpath) throws IOException, Failure {
            Files.createDirectories(sources);
            Files.createDirectories(classes);
            // Java 8, as Gradle itself: a later build may run on an older JVM than this one.
            List<String> arguments = new ArrayList<>(List.of("--release", "8", "-Xlint:-options", "-nowarn", "-proc:none",
                "-encoding", "UTF-8", "-d", classes.toString(), "-classpath",
                classpath.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator))));
            for (var source : SOURCES.entrySet()) {
                Path file = sources.resolve(source.getKey().substring(PACKAGE.length()) + ".java");
                arguments.add(Files.writeString(file, source.getValue()).toString());
            }
            ByteArrayOutputStream messages = new ByteArrayOutputStream();
            if (compiler.run(null, messages, messages, arguments.toArray(String[]::new)) != 0) {
                throw new Failure("Gradle " + VERSION + " could not be installed: the Java compiler failed.\n" + messages);
            }
        }

        byte[] classFile(String name) throws IOException {
            return Files.readAllBytes(classes.resolve(fileName(name)));
        }

        static String fileName(String name) {
            return name.replace('.', '/') + ".class";
        }
    }

    // ---------------------------------------------------------------------------------------------------------------------
    // Small things
    // ---------------------------------------------------------------------------------------------------------------------

    private static Properties loadProperties(byte[] content) throws IOException {
        Properties properties = new Properties();
        properties.load(new ByteArrayInputStream(content));
        return properties;
    }

    private static List<Path> subfolders(Path folder) throws IOException {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.filter(Files::isDirectory).toList();
        }
    }

    private static void deleteTree(Path folder) throws IOException {
        if (Files.notExists(folder)) {
            return;
        }
        List<Path> deepestFirst;
        try (Stream<Path> entries = Files.walk(folder)) {
            deepestFirst = entries.sorted(Comparator.reverseOrder()).toList();
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        for (Path path : deepestFirst) {
            Files.deleteIfExists(path);
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

    /** Java's message for the most common failures is only a path. */
    private static String reason(Exception e) {
        if (e instanceof AccessDeniedException denied) {
            return "there is no permission to write " + denied.getFile();
        } else if (e instanceof NoSuchFileException missing) {
            return missing.getFile() + " does not exist";
        } else if (e instanceof FileSystemException failed && failed.getReason() != null) {
            return failed.getFile() + ": " + failed.getReason();
        }
        return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
    }
}
