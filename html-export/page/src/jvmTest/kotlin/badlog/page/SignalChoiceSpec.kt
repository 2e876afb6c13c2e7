package badlog.page

import badlog.core.bag.BagTopic
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.SignalsFile
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import org.openqa.selenium.By
import org.openqa.selenium.Keys
import java.nio.file.Files
import kotlin.io.path.deleteExisting
import kotlin.io.path.writeBytes

/** The assignment of topics to signals that the rules lack, on the page. */
@Tags("InCheck")
internal class SignalChoiceSpec : PageSpec({
    val bag = bagOf(listOf(TIME, BagTopic("Power/My Volts", "V"), BagTopic("Arm", "m")), rows = 60) { row, column ->
        when (column) {
            0 -> row / 10.0
            1 -> if (row in 20..40) 6 else 12
            else -> 1
        }
    }
    val additions = PageAdditions(rules = RuleSet.BUILT_IN)

    fun OpenPage.awaitRules() = await("the rules") { script("return document.documentElement.dataset.rules") == "done" }

    /** Assigns [topic] to [signal] by typing it, as a reader does. */
    fun OpenPage.say(signal: String, topic: String) {
        if (element(".findings-skipped").getAttribute("open") == null) click(".findings-skipped summary")
        val field = elements(".signals-lacking").single { "“$signal”" in it.text }.findElement(By.tagName("input"))
        field.clear()
        field.sendKeys(topic, Keys.TAB)
        settle()
    }

    fun OpenPage.rulesFound() = texts(".finding-text, .incident p > span").joinToString("\n")

    browserTest("topics are assigned to signals, refused with a reason, removed and saved") {
        onPage(TestPages.of(bag, additions = additions)) {
            step("a topic assigned to the battery is used by the rules, also when the page is opened again, until it is removed") {
                awaitRules()
                rulesFound() shouldNotContain "The battery voltage dropped"
                say("battery", "Power/My Volts")
                awaitRules()
                rulesFound() shouldContain "The battery voltage dropped to 6 V"
                texts(".signals-chosen").single() shouldContain "“battery” is “Power/My Volts” in this browser."
                keepScreenshot("signal-chosen")
                reload()
                awaitRules()
                rulesFound() shouldContain "The battery voltage dropped to 6 V"
                click(".signals-chosen button")
                awaitRules()
                rulesFound() shouldNotContain "The battery voltage dropped"
                elements(".signals-chosen").isEmpty() shouldBe true
            }
            step("assignments are saved as the file for the folder of logs, and in a copy of the page") {
                awaitRules()
                say("battery", "Power/My Volts")
                awaitRules()
                val file = saved("badlog-signals.toml") { click(".signals-saved button") }
                SignalsFile.parse(file.decodeToString()).find("battery")?.topics?.map { it.pattern.text } shouldBe listOf("Power/My Volts")
                val copy = Files.createTempFile("badlog-copy", ".html")
                copy.writeBytes(exported("A copy of this page, with your notes and board", "test.html"))
                click(".signals-chosen button")
                awaitRules()
                onPage(copy) {
                    awaitRules()
                    rulesFound() shouldContain "The battery voltage dropped to 6 V"
                    click(".findings-skipped summary")
                    texts(".signals-lacking").map { it.trim() } shouldNotContain "“battery” is"
                }
                copy.deleteExisting()
            }
        }
    }
})
