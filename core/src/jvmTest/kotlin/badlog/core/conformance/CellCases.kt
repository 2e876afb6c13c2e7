package badlog.core.conformance

import badlog.core.recording.ProblemKind.DECIMAL_COMMA
import badlog.core.recording.ProblemKind.EMPTY_CELLS
import badlog.core.recording.ProblemKind.NOT_FINITE
import badlog.core.recording.ProblemKind.NOT_UTF8
import badlog.core.recording.ProblemKind.TEXT_IN_NUMBERS
import badlog.core.recording.ProblemKind.TRUTH_VALUES
import badlog.core.recording.TopicKind.BOOLEAN
import badlog.core.recording.TopicKind.EVENT
import badlog.core.recording.TopicKind.STATE

/** The contents of cells, and the kinds of topics that they make. */
internal val CELL_CASES = listOf(
    case(
        "numbers",
        "Numbers as %.5g writes them, and as other programs do, read to the nearest double; -0 keeps its sign.",
        POWER + "0.0000,-0.0000\n1.2346e+07,9.9999e-05\n12345,0.00012346\n0.1,1234567.8901234\n" +
            "1e-300,1.7976931348623157e308\n-3,0.30000000000000004\n007,123456789012345680\n1E3,-1.5E-2\n",
        bag(
            time(0, 12346000, 12345, 0.1, 1e-300, -3, 7, 1000),
            volts(
                -0.0,
                9.9999e-5,
                0.00012346,
                1234567.8901234,
                1.7976931348623157e308,
                0.30000000000000004,
                1.2345678901234568e17,
                -0.015,
            ),
        ),
    ),
    case(
        "padded-cells",
        "Spaces and tabs around a number do not count; those of a text do.",
        DRIVE + " 1 , auto ,\t12.5\n2,teleop,  \n",
        bag(time(1, 2), mode(" auto ", "teleop"), volts(12.5, null), problems = listOf(EMPTY_CELLS of "Volts")),
    ),
    case(
        "empty-cells",
        "An empty cell and null, in any case, are gaps, counted per topic; the gaps of a topic of texts are not reported.",
        DRIVE + "1,auto,12\n2,,\n3,null,NULL\n,auto,\"\"\n5,auto,11\n6,auto,10\n",
        bag(
            time(1, 2, 3, null, 5, 6),
            mode("auto", null, null, "auto", "auto", "auto"),
            volts(12, null, null, null, 11, 10),
            problems = listOf(EMPTY_CELLS of "Time", EMPTY_CELLS of "Volts"),
        ),
    ),
    case(
        "sparse-topic",
        "A number in fewer than half of the rows: sampled at times of its own, so its empty cells are not gaps.",
        POWER + "1,12\n2,\n3,\n4,11\n5,\n",
        bag(time(1, 2, 3, 4, 5), volts(12, null, null, 11, null)),
    ),
    case(
        "text-in-numbers",
        "A text among numbers is a gap, reported once per topic with the line of the first; the text itself is kept.",
        POWER + "1,12\n2,error\n3,12.5.1\n4,0x10\n5,11\n6,10.5\n7,12V\n8,9\n9,8\n",
        bag(
            time(1, 2, 3, 4, 5, 6, 7, 8, 9),
            volts(12, "error", "12.5.1", "0x10", 11, 10.5, "12V", 9, 8),
            problems = listOf(TEXT_IN_NUMBERS at 4 of "Volts"),
        ),
    ),
    case(
        "not-finite",
        "NaN and infinities, in the spellings of Java, C and Python, are kept as such; a front end draws gaps.",
        POWER + "NaN,Infinity\nnan,-Infinity\n3,inf\n4,-inf\n5,+Inf\n6,NAN\n7,7\n",
        bag(
            time(Double.NaN, Double.NaN, 3, 4, 5, 6, 7),
            volts(
                Double.POSITIVE_INFINITY,
                Double.NEGATIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                Double.NEGATIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                Double.NaN,
                7,
            ),
            problems = listOf(NOT_FINITE of "Time", NOT_FINITE of "Volts"),
        ),
    ),
    case(
        "truth-values",
        "true and false, in any case, are 1 and 0; a topic with nothing else is a state of two.",
        DRIVE_JSON.replace("Mode", "Enabled") + "\nTime,Enabled,Volts\n1,true,12\n2,FALSE,11\n3,True,10\n",
        bag(
            time(1, 2, 3),
            topic("Enabled", kind = BOOLEAN, cells = cells(true, false, true)),
            volts(12, 11, 10),
            problems = listOf(TRUTH_VALUES of "Enabled"),
        ),
    ),
    case(
        "truth-values-among-numbers",
        "Among numbers true and false are 1 and 0 as well, and that is said.",
        POWER + "1,12\n2,true\n3,0.5\n4,false\n",
        bag(time(1, 2, 3, 4), volts(12, true, 0.5, false), problems = listOf(TRUTH_VALUES of "Volts")),
    ),
    case(
        "events",
        "A topic mostly of texts, in fewer than half of the rows: events. A number there is a sample, not an event.",
        """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Log","unit":"ul","attrs":["log"]}],""" +
            """"values":[]}""" + "\nTime,Log\n1,enabled\n2,\n3,\n4,-1\n5,\n6,intake jammed\n",
        bag(
            topic("Time", "s", listOf("xaxis"), cells = cells(1, 2, 3, 4, 5, 6)),
            topic(
                "Log",
                attributes = listOf("log"),
                kind = EVENT,
                cells = cells("enabled", null, null, -1, null, "intake jammed"),
            ),
        ),
    ),
    case(
        "states",
        "A topic mostly of texts, in exactly half of the rows: states.",
        DRIVE + "1,auto,12\n2,,11\n3,,10\n4,teleop,9\n",
        bag(time(1, 2, 3, 4), mode("auto", null, null, "teleop"), volts(12, 11, 10, 9)),
    ),
    case(
        "as-many-texts-as-numbers",
        "As many texts as numbers are not mostly texts: numeric, with gaps.",
        POWER + "1,12\n2,low\n3,11\n4,low\n",
        bag(time(1, 2, 3, 4), volts(12, "low", 11, "low"), problems = listOf(TEXT_IN_NUMBERS at 4 of "Volts")),
    ),
    case(
        "decimal-comma",
        "A robot with a French locale writes quoted numbers with a comma; reported once per topic, with the first line.",
        POWER + "\"0,0200\",12\n\"0,0400\",\"1,2345e+01\"\n\"-0,5\",\"11\"\n",
        bag(
            time(0.02, 0.04, -0.5),
            volts(12, 12.345, 11),
            problems = listOf(DECIMAL_COMMA at 3 of "Time", DECIMAL_COMMA at 4 of "Volts"),
        ),
    ),
    case(
        "quoted-numbers",
        "A program that quotes every cell writes ordinary numbers; there is nothing to report.",
        "\"Time\",\"Count\"\n\"1\",\"10\"\n\"2\",\"20.5\"\n",
        csv(topic("Time", cells = cells(1, 2)), topic("Count", cells = cells(10, 20.5))),
    ),
    case(
        "comma-in-a-log",
        "In a topic with the log attribute a quoted 1,5 is a text as it stands.",
        """{"topics":[{"name":"Log","unit":"ul","attrs":["log"]},{"name":"A","unit":"ul","attrs":[]}],"values":[]}""" +
            "\nLog,A\n\"1,5\",1\n\"2,5\",2\n",
        bag(
            topic("Log", attributes = listOf("log"), kind = STATE, cells = cells("1,5", "2,5")),
            topic("A", cells = cells(1, 2)),
        ),
    ),
    bytesCase(
        "not-utf8-cells",
        "Text that is not UTF-8 is Windows-1252, reported once per topic; text that is UTF-8 stays so in the same topic.",
        DRIVE + "1,arr\u00eat,12\n2,\u0093go\u0094 \u0080,11\n3,\u00c3\u00a9t\u00c3\u00a9,10\n",
        bag(
            time(1, 2, 3),
            mode("arrêt", "“go” €", "été"),
            volts(12, 11, 10),
            problems = listOf(NOT_UTF8 at 3 of "Mode"),
        ),
    ),
    bytesCase(
        "not-utf8-header",
        "A header that is not UTF-8 is Windows-1252, reported once per line.",
        "{\"topics\":[{\"name\":\"Temp\u00e9rature\",\"unit\":\"\u00b0C\",\"attrs\":[]}],\"values\":[]}\n" +
            "Temp\u00e9rature\n21\n",
        bag(topic("Température", "°C", cells = cells(21)), problems = listOf(NOT_UTF8 at 1, NOT_UTF8 at 2)),
    ),
)
