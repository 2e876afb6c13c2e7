package badlog.release.tasks

import badlog.release.ROOT
import badlog.release.run
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import java.io.File
import kotlin.time.Duration.Companion.hours

/** Writes examples and expectations, as the tasks say. */
private val WRITING = listOf(
    ":formats:jvmTest", "--tests", "*LogCorpusSpec",
    ":expression:jvmTest", "--tests", "*GuideSpec",
    ":rules:jvmTest", "--tests", "*RulesGuideSpec",
)

/** Compiles every module that a task changes, and runs the specs that can miss a file. */
private val BUILDING = listOf(
    ":formats:jvmTest", ":formats:checkKotlinAbi",
    ":expression:jvmTest",
    ":rules:jvmTest", "--tests", "*RulesGuideSpec",
    ":rules:checkTest", "--tests", "*BuiltInRulesSpec",
    ":viewer:jvmTest", "--tests", "*ReduceSpec", "--tests", "*GestureSpec", "--tests", "*ListingSpec",
    ":catalog:test", "--tests", "*FolderStoreSpec",
    ":page:compileKotlinJs", ":desktop-viewer:compileKotlin",
    ":architecture:test",
)

class TasksProof : FunSpec({
    val project = File("project").absoluteFile
    val tasks = guidedTasksIn(File(ROOT, "CONTRIBUTING.md").readText())

    project.deleteRecursively()
    for (path in run(ProcessBuilder("git", "ls-files", "-z").directory(ROOT)).text.split('\u0000').filter { it.isNotEmpty() }) {
        File(ROOT, path).let { if (it.exists()) it.copyTo(File(project, path)).setExecutable(it.canExecute()) }
    }

    test("CONTRIBUTING.md leads to the five tasks that are tried") {
        tasks.map { it.title } shouldContainExactlyInAnyOrder EXAMPLES.keys
    }

    for (task in tasks) {
        test("“${task.title}” names the files that it needs, and no others") {
            val example = EXAMPLES.getValue(task.title)
            val walk = Walk(project, task).apply(example.steps)
            for (name in example.optional) walk.named(name)
            walk.unused.shouldBeEmpty()
        }
    }

    test("the project builds with all five").config(timeout = 2.hours, invocationTimeout = 2.hours) {
        gradle(project, WRITING, mapOf("BADLOG_WRITE_GUIDE" to "1", "BADLOG_WRITE_CONFORMANCE" to "1"))
        gradle(project, BUILDING)
    }
})

/** Runs [tasks] in [project] by the Gradle of this build, with its caches. Tests run even if they have before. */
private fun gradle(project: File, tasks: List<String>, variables: Map<String, String> = emptyMap()) {
    val launcher = File(System.getProperty("badlog.gradle"), "lib").listFiles().orEmpty().single { it.name.startsWith("gradle-launcher-") }
    val script = File("run-tests.gradle").absoluteFile
    script.writeText("allprojects { tasks.withType(Test).configureEach { outputs.upToDateWhen { false }; outputs.doNotCacheIf('It tries the guide.') { true } } }\n")
    val command = listOf(
        System.getProperty("java.home") + "/bin/java", "-Xmx128m", "-cp", "$launcher", "org.gradle.launcher.GradleMain",
        "-g", System.getProperty("badlog.gradle.home"), "-p", "$project", "-I", "$script", "--console=plain", "--continue",
        // Ends soon, so that it keeps no memory.
        "-Dorg.gradle.daemon.idletimeout=10000",
    ) + System.getProperty("badlog.gradle.options").split(' ').filter { it.isNotEmpty() } + tasks
    val ended = run(ProcessBuilder(command).directory(project).apply { environment() += variables }, minutes = 60)
    withClue(ended.text) { ended.code shouldBe 0 }
}
