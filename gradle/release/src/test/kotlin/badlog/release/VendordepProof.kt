package badlog.release

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File

class VendordepProof : FunSpec({
    val folder = tempFolder()

    test("a robot project with the offline vendordep, from WPILib's folder or by file://, compiles and logs").config(
        enabledOrReasonIf = CleanMachine.IF_POSSIBLE,
    ) {
        val season = File(folder, "wpilib/2026")
        unpacked(download("badlog-vendordep-2026-$VERSION.zip"), season)
        val vendordep = File(season, "vendordeps/Badlog.json")
        val projects = File(folder, "projects")
        for (name in listOf("local", "by-url")) robotProject(File(projects, name), vendordep)
        File(projects, "by-url/vendordeps/Badlog.json").writeText(
            vendordep.readText().replace(Regex("\"mavenUrls\": \\[.*?]"), "\"mavenUrls\": [\"file://$season/maven\"]"),
        )
        File(projects, "settings.gradle").writeText("include 'local', 'by-url'\n")
        File(projects, "local/build.gradle").appendText("repositories { maven { url = '$season/maven' } }\n")

        val java = System.getProperty("java.home")
        val launcher = File(System.getProperty("badlog.gradle"), "lib").listFiles().orEmpty().single { it.name.startsWith("gradle-launcher-") }
        val machine = CleanMachine(File(folder, "machine"), listOf("sh", "uname"))
        val ended = machine.run(
            listOf(
                "$java/bin/java", "-Xmx512m", "-Dfile.encoding=UTF-8", "-Duser.home=$folder/machine/home", "-cp", "$launcher", "org.gradle.launcher.GradleMain",
                "--no-daemon", "--offline", "-g", "$folder/gradle-home", "-p", "$projects", "logMatch",
            ),
            variables = mapOf("JAVA_HOME" to java),
        )
        withClue(ended.text) { ended.code shouldBe 0 }

        val badlog = File(unpacked(download("badlog-$VERSION.zip"), File(folder, "badlog")), "bin/badlog")
        for (name in listOf("local", "by-url")) {
            val log = File(projects, "$name/logs").listFiles().orEmpty().single { it.name.startsWith("FRC_") }
            val found = run(ProcessBuilder("$badlog", "find", "$log", "max(Arm/Angle) == 45", "--json", "--no-cache"))
            withClue(found.text) { found.code shouldBe 0 }
            found.text shouldContain "\"status\":\"whole\""
        }
    }
})

/**
 * Makes a robot project as in docs/robot.md. It has stand-ins for WPILib, because not every machine reaches the registry of WPILib's Gradle
 * plugin.
 */
private fun robotProject(folder: File, vendordep: File) {
    vendordep.copyTo(File(folder, "vendordeps/Badlog.json"))
    val guide = File(ROOT, "docs/robot.md").readText()
    val sources = File(folder, "src/main/java")
    File(sources, "frc/robot/Robot.java").apply { parentFile.mkdirs() }.writeText(guide.substringAfter("```java\n").substringBefore("```"))
    File(ROOT, "jvm-robot/src/test/java/edu").copyRecursively(File(sources, "edu"))
    File(sources, "frc/robot/Main.java").writeText(
        """
        package frc.robot;

        import edu.wpi.first.wpilibj.DriverStation;
        import edu.wpi.first.wpilibj.RobotController;
        import java.io.File;

        public class Main {
            public static void main(String[] arguments) throws InterruptedException {
                DriverStation.enabled = true;
                RobotController.systemTimeValid = true;
                Robot robot = new Robot();
                // Another thread creates the log, on a busy machine perhaps late.
                for (int i = 0; i < 60 || (!hasRows() && i < 20_000); i++) {
                    robot.robotPeriodic();
                    Thread.sleep(5);
                }
            }

            private static boolean hasRows() {
                File[] logs = new File("logs").listFiles();
                return logs != null && logs.length == 1 && logs[0].length() > 3_000;
            }
        }
        """.trimIndent(),
    )
    // Does the same with vendordeps as WPILib's plugin.
    File(folder, "build.gradle").writeText(
        """
        plugins { id 'java' }
        file('vendordeps').listFiles().each { vendordep ->
            def json = new groovy.json.JsonSlurper().parse(vendordep)
            json.mavenUrls.each { address -> repositories { maven { url = address } } }
            json.javaDependencies.each { dependencies.add('implementation', "${'$'}it.groupId:${'$'}it.artifactId:${'$'}it.version") }
        }
        tasks.withType(JavaCompile).configureEach {
            options.release = 17
            options.fork = true
            options.forkOptions.executable = System.getProperty('java.home') + '/bin/javac'
        }
        tasks.register('logMatch', JavaExec) {
            classpath = sourceSets.main.runtimeClasspath
            mainClass = 'frc.robot.Main'
            workingDir = projectDir
        }

        """.trimIndent(),
    )
}
