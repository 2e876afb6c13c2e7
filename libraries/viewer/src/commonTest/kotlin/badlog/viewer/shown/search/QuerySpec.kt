package badlog.viewer.shown.search

import badlog.viewer.bagView
import badlog.viewer.shown.outline.traits
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll

class QuerySpec : FunSpec({
    test("all words must occur, in any order, regardless of case") {
        Query("Left  drive").matches("Drivetrain/LEFT Output") shouldBe true
        Query("left arm").matches("drivetrain/left output") shouldBe false
        Query("  ").isEmpty shouldBe true
        Query("\t").matches("") shouldBe true
        Query("Left").matchesLowercase("left") shouldBe true
    }

    test("a bar finds either side, a minus excludes, and quotes keep words together") {
        fun found(query: String) = listOf("Left Speed", "Right Speed", "Speed Left", "Arm").filter(Query(query)::matches)
        found("left | arm") shouldBe listOf("Left Speed", "Speed Left", "Arm")
        found("speed -right") shouldBe listOf("Left Speed", "Speed Left")
        found("-speed") shouldBe listOf("Arm")
        found("\"left speed\"") shouldBe listOf("Left Speed")
        found("-\"left speed\" speed|arm") shouldBe listOf("Right Speed", "Speed Left", "Arm")
    }

    test("a word finds its other forms, and other words for the same thing, but quotes are exact") {
        Query("brownout").matches("System/Browned Out") shouldBe true
        Query("Brownouts").matches("The roboRIO browned out at 93.7 s") shouldBe true
        Query("browned out").matches("brownout, outputs cut") shouldBe true
        Query("-brownout").matches("Browned Out") shouldBe false
        Query("\"brownout\"").matches("Browned Out") shouldBe false
        Query("stalls").matches("Motor stalled") shouldBe true
        Query("slipping").matches("Wheels slip") shouldBe true
        Query("pdh current").matches("PowerDistribution/ChannelCurrent[3]") shouldBe true
        Query("gyro").matches("Pigeon 2/Yaw") shouldBe true
    }

    test("a shorter form counts where a word begins, and only words have forms") {
        Query("heading").matches("Head Angle") shouldBe true
        Query("heading").matches("overhead") shouldBe false
        Query("gyro").matches("Maximum") shouldBe false
        Query("autonomous").matches("Is auto") shouldBe true
        Query("status").matches("Statue") shouldBe false
        Query("speed").matches("Special") shouldBe false
        Query("loss").matches("closed") shouldBe false
    }

    test("an incomplete query finds the same as before") {
        for (text in listOf("left |", "| left", "left -", "left \"", "left -\"", "left||")) {
            Query(text).matches("Left") shouldBe true
            Query(text).matches("Right") shouldBe false
        }
        for (text in listOf("|", "-", "\"", "\"\"", " | - ")) Query(text).isEmpty shouldBe true
    }

    test("traits can be searched for, alone and with words, and other words with a colon are words") {
        Query("is:state mode").matches("Mode", setOf(Trait.STATE)) shouldBe true
        Query("is:state mode").matches("Mode", setOf(Trait.NUMBER)) shouldBe false
        Query("-is:constant").matches("Mode", setOf(Trait.NUMBER)) shouldBe true
        Query("IS:empty | has:finding").matches("", setOf(Trait.FINDING)) shouldBe true
        Query("is:other").matches("this is:other") shouldBe true
        Query("DS:enabled").matches("DS:enabled") shouldBe true
        Query("\"is:state\"").matches("Mode", setOf(Trait.STATE)) shouldBe false
        Query("a -has:finding").asksFor(Trait.FINDING) shouldBe true
        Query("finding").asksFor(Trait.FINDING) shouldBe false
    }

    test("the highlighted words are the searched ones") {
        Query("Left -right \"top speed\" is:state | arm").words shouldBe listOf("left", "top speed", "arm")
        Query("stalls").words shouldBe listOf("stalls", "stall")
    }

    test("the traits of a topic follow from its samples") {
        val view = bagView(listOf("Time|xaxis", "Number", "Still", "Mode", "Nothing"), listOf("0,1,5,auto,", "1,2,5,teleop,"))
        val traits = view.recording.topics.associate { it.name to view.seriesOf(it).traits }
        traits["Number"] shouldBe setOf(Trait.NUMBER)
        traits["Still"] shouldBe setOf(Trait.NUMBER, Trait.CONSTANT)
        traits["Mode"] shouldBe setOf(Trait.STATE)
        traits["Nothing"] shouldBe setOf(Trait.EMPTY)
    }

    test("any text is searched for, or shows everything") {
        val texts = Arb.list(Arb.element("a", "B", " ", "|", "-", "\"", "is:", "state", "has:finding", "\t", "é"), 0..12).map { it.joinToString("") }
        checkAll(texts, texts) { text, searched ->
            val query = Query(text)
            if (query.isEmpty) query.matches(searched) shouldBe true
            query.matches(searched) shouldBe query.matchesLowercase(searched.lowercase())
            for (word in query.words) word.isEmpty() shouldBe false
        }
    }
})
