package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.inspectors.forAtLeastOne
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files

@Tags("InCheck")
internal class ProblemSectionSpec : PageSpec({
    browserTest("the losses of a cut bag are listed with text and line, fold by mouse, and are printed from a phone that folds them") {
        val page = TestPages.ofSample("practice.bag")
        fun OpenPage.lost() = elements(".problem").map { it.text }.filter { it.startsWith("lost") }
        onPage(page) {
            val lastLine = Files.readAllBytes(SAMPLES.resolve("practice.bag")).count { it == '\n'.code.toByte() } + 1
            lost().forAtLeastOne {
                it shouldContain "45.382"
                it shouldContain "line $lastLine"
            }
            click("#problems summary")
            lost().size shouldBe 0
            click("#problems summary")
            lost().size shouldBe 4
        }
        onPage(page, Screen.PHONE) {
            lost().size shouldBe 0
            script("dispatchEvent(new Event('beforeprint'))")
            lost().size shouldBe 4
            script("dispatchEvent(new Event('afterprint'))")
            lost().size shouldBe 0
        }
    }
})
