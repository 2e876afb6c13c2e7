package badlog.lib

import badlog.core.platform.Wine
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.io.File

/** All tests of what runs on a robot, on the machines of robots and of their programmers: `./gradlew :jvm-robot:platforms -Pall`. */
class AllTestsOnPlatformsSpec : FunSpec({
    val wine = lazy { Wine() }
    afterSpec { if (wine.isInitialized()) wine.value.close() }

    for (platform in Platform.all) {
        val enabled = if (platform.isMissing) Enabled.disabled(platform.missing) else Enabled.enabled

        for (module in listOf("core", "jvm-robot")) {
            test("${platform.name}: the tests of $module").config(enabledOrReasonIf = { enabled }) {
                val all = System.getProperty("badlog.platforms.specs.$module").split(';')
                val specs = if (platform.listsDisks) all else all.filterNot { it.substringAfterLast('.') in LISTING }
                val classpath = System.getProperty("badlog.platforms.classpath.$module").split(File.pathSeparator)
                val memory = if (platform.listsDisks) emptyList() else listOf("-Djava.io.tmpdir=/dev/shm")
                val launcher = memory + listOf("io.kotest.engine.launcher.MainKt", "--specs", specs.joinToString(";"), "--listener", "teamcity")
                val run = platform.run({ wine.value }, classpath, launcher, File(System.getProperty("badlog.platforms.folder.$module")), LIMIT_MINUTES)
                val lines = run.text.lines()
                lines.filter { it.startsWith("##teamcity[testFailed") }.shouldBeEmpty()
                withClue(lines.takeLast(20).joinToString("\n")) { run.code shouldBe 0 }
                lines.count { it.startsWith("##teamcity[testFinished") && "result_status='Success'" in it } shouldBeGreaterThan specs.size
            }
        }
    }
})

/** What lists a folder of the project. */
private val LISTING = setOf("CheckedInCorpusSpec")
private const val LIMIT_MINUTES = 60L
