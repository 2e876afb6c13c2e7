package badlog.page

import badlog.core.bag.BagTopic
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe

/** States drawn as lanes of blocks. */
@Tags("InCheck")
internal class LaneSpec : PageSpec({
    // The modes take a quarter of the width each.
    val modes = listOf("disabled", "autonomous", "teleop", "test")
    val page by lazy {
        val topics = listOf(TIME, BagTopic("Mode"), BagTopic("Level", "V"))
        TestPages.of(
            bagOf(topics, 401) { row, column ->
                when (column) {
                    0 -> row / 10.0
                    1 -> modes[minOf(row / 100, 3)]
                    else -> row
                }
            },
        )
    }

    browserTest("states are lanes of blocks, named where there is room, shaded by modes, and seen in a whole match") {
        step("the name of a state stands inside the block of that state, and lanes and lines have the same x") {
            onPage(page, script = NOTING_TEXTS) {
                val frame = graph("Mode").frame
                frame.x shouldBe graph("Level").frame.x
                frame.width shouldBe graph("Level").frame.width
                val left = frameLeft("Mode")
                val names = drawnTexts("Mode").filter { it.text in modes }
                names.shouldNotBeEmpty()
                names.forAll { name ->
                    val from = left + frame.width * modes.indexOf(name.text) / 4
                    withClue("block from $from to ${from + frame.width / 4}") {
                        name.left shouldBeGreaterThan from
                        name.right shouldBe (from + frame.width / 8 plusOrMinus frame.width / 8)
                    }
                }
            }
        }
        step("the brownouts of a match are visible in the whole match") {
            onPage(TestPages.ofSample("qualification-42.bag")) {
                graph("System/States").scrollTo()
                for (other in listOf("Enabled", "Autonomous")) graph("System/States").legend(other).click()
                settle()
                val picture = graph("System/States").picture
                val columns = picture.columnsOf(color("--line-1"))
                // From 93.7 to 97.4 s of some 156 s.
                val seen = columns.indices.filter { columns[it] > picture.height / 5 }
                seen.size shouldBeGreaterThan 5
                seen.forAll { it.toDouble() / columns.size shouldBe (0.61 plusOrMinus 0.03) }
            }
        }
        step("states that follow one another are lanes of one graph, 18 px each, and show how long and how often") {
            val bag = bagOf(listOf(TIME, BagTopic("A/On"), BagTopic("A/Mode"), BagTopic("A/Level", "V")), 401) { row, column ->
                when (column) {
                    0 -> row / 10.0
                    1 -> row / 100 % 2 == 1
                    2 -> modes[minOf(row / 100, 3)]
                    else -> row
                }
            }
            onPage(TestPages.of(bag)) {
                graphNames shouldBe listOf("A/States", "A/Level")
                graph("A/States").frame.height shouldBe 36.0
                graph("A/States").hover(0.6)
                graph("A/States").value("On") shouldBe "false"
                graph("A/States").value("Mode") shouldBe "teleop"
                script("arguments[0].querySelector('.statistics-toggle').click()", graph("A/States").card)
                texts(".statistics tbody tr").take(2) shouldBe listOf("Onfalse20 s50.0 %3", "true20 s50.0 %2")
            }
        }
        step("a block that is too narrow for its name has none") {
            val bag = bagOf(listOf(TIME, BagTopic("On")), 400) { row, column ->
                if (column == 0) row / 10.0 else row / 8 % 2 == 0
            }
            onPage(TestPages.of(bag), script = NOTING_TEXTS) {
                drawnTexts("On").none { "…" in it.text } shouldBe true
            }
        }
        step("lanes are shaded by the robot's modes, as lines are") {
            val bag = bagOf(listOf(TIME, BagTopic("System/Enabled"), BagTopic("System/Autonomous"), BagTopic("Other/Pressed")), 101) { row, column ->
                when (column) {
                    0 -> row / 10.0
                    1 -> row >= 50
                    2 -> false
                    else -> false
                }
            }
            onPage(TestPages.of(bag, additions = PageAdditions(rules = RuleSet.BUILT_IN))) {
                fun shadeAt(share: Double) = script(
                    """
                    const canvas = arguments[0].querySelector('canvas'), frame = arguments[0].querySelector('.plot-frame').getBoundingClientRect()
                    const box = canvas.getBoundingClientRect(), ratio = devicePixelRatio
                    const x = (frame.left - box.left + frame.width * arguments[1]) * ratio, y = (frame.top - box.top + 4) * ratio
                    const pixel = new OffscreenCanvas(1, 1).getContext('2d', {willReadFrequently: true})
                    pixel.drawImage(canvas, -x, -y)
                    return [...pixel.getImageData(0, 0, 1, 1).data].join()
                    """.trimIndent(),
                    graph("Other/Pressed").scrollTo().card,
                    share,
                )
                (shadeAt(0.25) == shadeAt(0.75)) shouldBe false
            }
        }
    }
})
