package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.matchers.shouldBe

@Tags("InCheck")
internal class ProblemSectionSpec : PageSpec({
    browserTest("losses unfold by mouse, and are printed from a phone that folds them") {
        val page = TestPages.ofSample("practice.bag")
        fun OpenPage.lost() = elements(".problem").map { it.text }.filter { it.startsWith("lost") }
        onPage(page, Screen.PHONE) {
            lost().size shouldBe 0
            script("dispatchEvent(new Event('beforeprint'))")
            lost().size shouldBe 4
            script("dispatchEvent(new Event('afterprint'))")
            lost().size shouldBe 0
            click("#problems summary")
            lost().size shouldBe 4
        }
    }
})
