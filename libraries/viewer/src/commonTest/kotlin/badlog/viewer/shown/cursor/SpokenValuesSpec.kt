package badlog.viewer.shown.cursor

import badlog.viewer.bagView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class SpokenValuesSpec : FunSpec({
    val topics = listOf("Time|xaxis", "A", "Mode", "C", "D", "E")
    val view = bagView(topics, listOf("0,1,auto,3,4,5", "1,,teleop,3,4,5", "2,2,teleop,3,4,5"))

    fun lines(vararg names: String) = names.map { name -> view.seriesOf(view.recording.topics.single { it.name == name }) }

    test("a place is announced with the values of its lines and their units, a state by its name, and a gap as a dash") {
        spokenAt(lines("A", "Mode"), 0.0, "0.000 s") shouldBe "0.000 s, A 1 V, Mode auto"
        spokenAt(lines("A", "Mode"), 1.0, "1.000 s") shouldBe "1.000 s, A –, Mode teleop"
        spokenAt(emptyList(), 1.0, "1.000 s") shouldBe "1.000 s"
    }

    test("only the first few values of many lines are announced") {
        spokenAt(lines("A", "C", "D", "E", "Mode"), 0.0, "0.000 s") shouldBe "0.000 s, A 1 V, C 3 V, D 4 V, E 5 V"
    }
})
