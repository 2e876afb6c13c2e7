package badlog.report

import badlog.report.page.reportPage
import badlog.rules.BUILT_IN_PROVEN
import badlog.rules.RuleSet
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive

class IncidentsSpec : FunSpec({
    val result = Report(RuleSet.BUILT_IN_PROVEN).over(SAMPLES.filter { "42" in it.name })
    val log = result.logs.single()

    test("the brownout of match 42 is its first incident, with its causes") {
        val incident = log.incidents.first()
        incident.name shouldBe "The robot drew more than its battery gives"
        incident.effects.map { it.rule } shouldContain "Browned out"
    }

    test("an incident is above the findings of its match, in text and on the index page") {
        val lines = reportText(result).lines()
        lines[1] shouldContain "Likely cause: the robot drew more than its battery gives."
        val page = reportPage(result) { "q42.html" }
        val incident = page.substringAfter("<ol class=\"incidents\"").substringBefore("</ol>")
        incident shouldContain "<li class=\"error\""
        incident shouldContain "href=\"./q42.html#t=93.7"
        incident shouldContain "Next: See which channels drew most then"
        page.indexOf("class=\"incidents\"") shouldBeLessThan page.indexOf("class=\"findings\"")
    }

    test("a spreadsheet gets a line for each incident, and for each finding the incident that it is part of") {
        val lines = reportCsv(result).lines()
        val incident = lines.first { ",incident,error," in it }
        incident shouldContain "Likely cause: the robot drew more than its battery gives."
        incident shouldContain ",s,The robot drew more than its battery gives,See which channels drew most then"
        lines.first { ",Browned out," in it } shouldContain ",The robot drew more than its battery gives,"
        lines.indexOf(incident) shouldBe 1
    }

    test("the JSON has its sentences, each with its evidence") {
        val json = Json.parseToJsonElement(Json.encodeToString(ReportJson.serializer(), ReportJson(log))).jsonObject
        val incident = json.getValue("incidents").jsonArray.first().jsonObject
        incident.getValue("severity").jsonPrimitive.content shouldBe "error"
        val sentences = incident.getValue("sentences").jsonArray.map { it.jsonObject }
        sentences.map { it.getValue("rule").jsonPrimitive.content } shouldContain "Browned out"
        sentences.all { it.getValue("evidence").jsonArray.isNotEmpty() } shouldBe true
        incident.getValue("effects").jsonArray.map { it.jsonPrimitive.content } shouldContain "Low battery"
    }
})
