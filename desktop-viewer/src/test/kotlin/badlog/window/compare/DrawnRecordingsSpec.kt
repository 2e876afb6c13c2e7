package badlog.window.compare

import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class DrawnRecordingsSpec : FunSpec({
    fun match(event: String, number: Int, file: String) = recordingOf(
        """{"topics":[{"name":"A","unit":"ul","attrs":[]}],"values":[{"name":"Event Name","value":"$event"},""" +
            """{"name":"Match Type","value":"Qualification"},{"name":"Match Number","value":"$number"}]}""" + "\nA\n1\n2\n",
        file,
    )

    test("matches of one event are distinguished by their numbers alone") {
        namesOf(listOf(match("Mill Creek", 42, "a.bag"), match("Mill Creek", 57, "b.bag"))) shouldBe
            listOf("Qualification 42", "Qualification 57")
    }

    test("matches of several events keep the event") {
        namesOf(listOf(match("Mill Creek", 42, "a.bag"), match("Lake", 42, "b.bag"))) shouldBe
            listOf("Mill Creek Qualification 42", "Lake Qualification 42")
    }

    test("what is called the same is distinguished by its file") {
        namesOf(listOf(match("Lake", 3, "a.bag"), match("Lake", 3, "b.bag"), recordingOf("A\n1\n2\n", "bench.csv"))) shouldBe
            listOf("Qualification 3 (a.bag)", "Qualification 3 (b.bag)", "bench.csv (bench.csv)")
    }
})
