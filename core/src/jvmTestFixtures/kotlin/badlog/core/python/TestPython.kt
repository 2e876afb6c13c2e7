package badlog.core.python

import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import java.io.IOException

/**
 * A Python that has [module]: the one that CI installs for tests, see `gradle/python.gradle`, or the system's.
 *
 * @param from the package to install if neither has it.
 */
internal class TestPython(private val module: String, private val from: String) {
    /** Its command; null if there is none. */
    val command: String? = listOfNotNull(System.getProperty("badlog.python"), "python3").firstOrNull { ends(it, "-c", "import $module") }

    /** A condition for tests that need it. */
    val isHere: EnabledOrReasonIf = {
        if (command != null) Enabled.enabled else Enabled.disabled("No Python here has $from; .ci/install installs one.")
    }

    /** Python as it runs [script] with [arguments]; its error output is printed. */
    fun running(script: String, vararg arguments: String): Process =
        ProcessBuilder(command, script, *arguments).redirectError(ProcessBuilder.Redirect.INHERIT)
            .apply { environment()["PYTHONIOENCODING"] = "utf-8" }.start()
}

/** Whether hooks in Python can run. */
internal val HAS_PYTHON: Boolean by lazy { ends("python3", "--version") }

private fun ends(vararg command: String): Boolean = try {
    ProcessBuilder(*command).redirectErrorStream(true).start().run {
        inputStream.readAllBytes()
        waitFor() == 0
    }
} catch (_: IOException) {
    false
}
