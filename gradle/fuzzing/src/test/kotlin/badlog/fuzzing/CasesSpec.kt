package badlog.fuzzing

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotBeEmpty
import java.io.File

/** Gradle runs the tests of a module in the module's folder. */
private val CORPORA = listOf("../../core/conformance", "../../libraries/formats/conformance").map(::File)

/** Reads every seed and every finding of coverage-guided fuzzing, so that fixed defects stay fixed. */
internal class CasesSpec : FunSpec({
    for (target in FuzzTarget.entries) {
        test("each case of ${target.folder} is read without an exception, with the same result in any pieces") {
            val own = File("cases/${target.folder}").listFiles().orEmpty().toList()
            val corpus = CORPORA.flatMap { it.listFiles().orEmpty().toList() }.filter { it.extension in target.extensions }
            val cases = (own + corpus).sortedBy { it.path }
            cases.shouldNotBeEmpty()
            for (case in cases) withClue(case.path) { target.read(case.readBytes()) }
        }
    }
})
