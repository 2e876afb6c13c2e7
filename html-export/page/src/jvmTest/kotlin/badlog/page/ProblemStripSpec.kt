package badlog.page

import badlog.protocol.PageAdditions
import io.kotest.core.annotation.Tags
import io.kotest.inspectors.forAtLeastOne
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files

@Tags("InCheck")
internal class ProblemStripSpec : PageSpec({
    browserTest("what a file has lost is listed, also on paper, and hints are quiet") {
        step("the losses of a cut bag are listed at once with line and text, counted, and fold by mouse") {
            onPage(TestPages.ofSample("practice.bag")) {
                element(".problem-list").isDisplayed shouldBe true
                elements(".problem").map { it.getDomAttribute("data-kind") } shouldContainAll listOf("NUL_HOLE", "ROW_CUT")
                val lastLine = Files.readAllBytes(SAMPLES.resolve("practice.bag")).count { it == '\n'.code.toByte() } + 1
                val cut = elements(".problem[data-kind='ROW_CUT']").map { it.text }
                cut.forAtLeastOne { it shouldContain "line $lastLine" }
                cut.forAtLeastOne { it shouldContain "45.382" }
                element("#problems").getDomAttribute("data-errors")!!.toInt() shouldBe
                    texts(".problem .severity").count { it == "lost" }
                click(".problems-toggle")
                element(".problem-list").isDisplayed shouldBe false
                click(".problems-toggle")
                element(".problem-list").isDisplayed shouldBe true
            }
        }
        step("the problems that a phone folds are listed on paper, and folded again afterwards") {
            onPage(TestPages.ofSample("practice.bag"), Screen.PHONE) {
                val isListed = { element(".problem-list").isDisplayed }
                isListed() shouldBe false
                script("dispatchEvent(new Event('beforeprint'))")
                isListed() shouldBe true
                texts(".problem").forAtLeastOne { it shouldContain "45.382" }
                script("dispatchEvent(new Event('afterprint'))")
                isListed() shouldBe false
                click(".problems-toggle")
                for (type in listOf("beforeprint", "afterprint")) script("dispatchEvent(new Event('$type'))")
                isListed() shouldBe true
            }
        }
        step("a phone lists the mistake in a page's formula at once, unless the file's losses would be listed with it") {
            val wrong = PageAdditions(listOf("Bad ="))
            for ((page, isListed) in listOf(TestPages.of(stepBag(graphs = 1), additions = wrong) to true, TestPages.ofSample("practice.bag", wrong) to false)) {
                onPage(page, Screen.PHONE) { element(".problem-list").isDisplayed shouldBe isListed }
            }
        }
        step("hints alone are one quiet line") {
            onPage(TestPages.of("Time,A\n0,true\n1,false\n\n2,true\n", "hints.csv")) {
                element("#problems").getDomAttribute("data-errors") shouldBe "0"
                element("#problems").getDomAttribute("data-warnings") shouldBe "0"
                element("#problems").text shouldContain "hint"
                element("#problems").size.height shouldBeLessThan 30
                element(".problem-list").isDisplayed shouldBe false
            }
        }
    }
})
