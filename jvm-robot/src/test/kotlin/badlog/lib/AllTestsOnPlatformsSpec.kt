package badlog.lib

import badlog.core.platform.Wine
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.io.File
import java.nio.file.Files
import java.nio.file.Path

/** All tests of the robot's code on the machines of robots and programmers: `./gradlew :jvm-robot:platforms -Pall`. */
class AllTestsOnPlatformsSpec : FunSpec({
    val wine = lazy { Wine() }
    afterSpec { if (wine.isInitialized()) wine.value.close() }

    for (platform in Platform.all) {
        val hasMemory = File.separatorChar == '/' && Files.isDirectory(MEMORY)
        val enabled = when {
            platform.isMissing -> Enabled.disabled(platform.missing)
            !platform.listsDisks && !hasMemory -> Enabled.disabled("this system has no folder in memory")
            else -> Enabled.enabled
        }

        for (module in listOf("core", "jvm-robot")) {
            test("${platform.name}: the tests of $module").config(enabledOrReasonIf = { enabled }) {
                val specs = System.getProperty("badlog.platforms.specs.$module")
                val classpath = System.getProperty("badlog.platforms.classpath.$module").split(File.pathSeparator)
                val launcher = listOf("io.kotest.engine.launcher.MainKt", "--specs", specs, "--listener", "teamcity")
                val folder = File(System.getProperty("badlog.platforms.folder.$module"))
                val run = if (platform.listsDisks) {
                    platform.run({ wine.value }, classpath, launcher, folder, LIMIT_MINUTES)
                } else {
                    inMemory(folder) { copy -> platform.run({ wine.value }, classpath, listOf("-Djava.io.tmpdir=$MEMORY") + launcher, copy, LIMIT_MINUTES) }
                }
                val lines = run.text.lines()
                lines.filter { it.startsWith("##teamcity[testFailed") }.shouldBeEmpty()
                withClue(lines.takeLast(20).joinToString("\n")) { run.code shouldBe 0 }
                lines.count { it.startsWith("##teamcity[testFinished") && "result_status='Success'" in it } shouldBeGreaterThan specs.split(';').size
            }
        }
    }
})

/**
 * Calls [run] with a folder in memory. Tests can run in it as in [folder], which is core's or an empty one. The corpus is copied, because
 * tests list its files; the rest of the project is linked.
 */
private fun <T> inMemory(folder: File, run: (File) -> T): T {
    val root = generateSequence(folder.absoluteFile) { it.parentFile }.first { File(it, "settings.gradle.kts").exists() }
    val copy = Files.createTempDirectory(MEMORY, "badlog").toFile()
    fun link(from: File) = Files.createSymbolicLink(File(copy, from.relativeTo(root).path).toPath(), from.toPath())
    val core = File(copy, "core").apply { mkdir() }
    root.listFiles().orEmpty().filter { it.name != "core" }.forEach(::link)
    File(root, "core").listFiles().orEmpty().filter { it.name != "conformance" }.forEach(::link)
    File(root, "core/conformance").copyRecursively(File(core, "conformance"))
    try {
        return run(if (folder.name == "core") core else File(copy, "scratch").apply { mkdir() })
    } finally {
        // Follows no link.
        Files.walk(copy.toPath()).use { it.sorted(Comparator.reverseOrder()).forEach(Files::delete) }
    }
}

private val MEMORY = Path.of("/dev/shm")
private const val LIMIT_MINUTES = 60L
