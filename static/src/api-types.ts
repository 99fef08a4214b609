// Generated from the OpenAPI document by `npm run api-types`: change the server's schemas instead.
export interface paths {
    "/api/v1/clips": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Clips
         * @description The clips: samples for everybody, imported ones for researchers.
         */
        get: operations["list_clips"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}/download.bvh": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Bvh
         * @description The clip as a BVH file, in centimetres.
         */
        get: operations["download_bvh"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}/download.glb": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Glb
         * @description The clip as a GLB file with its figure.
         */
        get: operations["download_glb"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Clip
         * @description One clip and the report of its import.
         */
        get: operations["show_clip"];
        put?: never;
        post?: never;
        /**
         * Delete Clip
         * @description Delete an imported clip.
         */
        delete: operations["delete_clip"];
        options?: never;
        head?: never;
        /**
         * Correct Clip
         * @description Read the clip's file again with corrections. The clip gets another id.
         */
        patch: operations["correct_clip"];
        trace?: never;
    };
    "/api/v1/clips/{clip_id}/confirm": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Confirm Clip
         * @description Keep an imported clip as its report describes it.
         */
        post: operations["confirm_clip"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/imports": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Import Motion
         * @description Read a BVH file; its clip then waits to be confirmed.
         *
         *     201 for a new clip, 200 when the same motion is in the library already.
         */
        post: operations["import_motion"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sessions/{token}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Session
         * @description The study, this participant's trials in order, the answers so far and where to go on.
         */
        get: operations["show_session"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sessions/{token}/responses": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Record Response
         * @description Store one answer. Acknowledged only once it is on the disk; safe to send again.
         */
        post: operations["record_response"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sessions/{token}/complete": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Complete
         * @description Close the session once every clip has an answer, and give the completion code.
         */
        post: operations["complete"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/results": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Results
         * @description All numbers of the results page.
         */
        get: operations["read_results"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
}
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        /**
         * Answer
         * @description One judged clip, as the page sends it.
         *
         *     Attributes:
         *         revision: 1 for the first answer, one more for each change after going back.
         *         answers: scale id to step, 0 in the middle.
         *         touched: the scales that were set by hand; the others kept the preselected middle.
         *         rt_ms: from the trial's start to the answer; time_elapsed_ms: from the session page's.
         *         client_time: the browser's clock.
         */
        Answer: {
            /** Trial Index */
            trial_index: number;
            /** Revision */
            revision: number;
            /** Answers */
            answers: {
                [key: string]: number;
            };
            /** Touched */
            touched: string[];
            /**
             * Comment
             * @default
             */
            comment: string;
            /** Rt Ms */
            rt_ms: number;
            /** Time Elapsed Ms */
            time_elapsed_ms: number;
            /**
             * Client Time
             * Format: date-time
             */
            client_time: string;
            record: components["schemas"]["ViewingRecord"];
        };
        /**
         * AnswerReceipt
         * @description The answer is durably stored.
         */
        AnswerReceipt: {
            /** Trial Index */
            trial_index: number;
            /** Revision */
            revision: number;
            /**
             * Received At
             * Format: date-time
             */
            received_at: string;
        };
        /**
         * Axis
         * @description All clips on one axis, in the study's order.
         */
        Axis: {
            /** Id */
            id: string;
            /** Left */
            left: string;
            /** Right */
            right: string;
            /** Cells */
            cells: components["schemas"]["Cell"][];
            /** Sentence */
            sentence: string;
        };
        /** Body_import_motion */
        Body_import_motion: {
            /**
             * File
             * @description A BVH file
             */
            file: string;
            /**
             * Options
             * @description ImportOptions as JSON
             * @default {}
             */
            options: string;
        };
        /**
         * Cell
         * @description One clip on one axis.
         *
         *     Attributes:
         *         mean: toward the right pole is positive; low, high: t-based 95 % interval.
         *         shares: part of the answers at each step from left to right, in 0 ... 1.
         */
        Cell: {
            /** Clip */
            clip: string;
            /** N */
            n: number;
            /** Mean */
            mean: number | null;
            /** Sd */
            sd: number | null;
            /** Low */
            low: number | null;
            /** High */
            high: number | null;
            /** Shares */
            shares: number[] | null;
        };
        /**
         * Clip
         * @description A clip of the study.
         */
        Clip: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /** Label */
            label: string;
            /** Body */
            body: string;
            /** Style */
            style: string;
        };
        /**
         * ClipDetail
         * @description A clip with the report of its import; samples have none.
         * @example {
         *       "cyclic": true,
         *       "duration": 1.6,
         *       "figure_url": "/media/7d793037a0760186574b0282f2f435e77d793037a0760186574b0282f2f435e7.glb",
         *       "frame_time": 0.0333333,
         *       "frames": 49,
         *       "glb_url": "/media/5d41402abc4b2a76b9719d911017c5925d41402abc4b2a76b9719d911017c592.glb",
         *       "id": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "name": "set_b_sad_slow",
         *       "page_url": "/library/0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "poster_time": 0.8,
         *       "source": "sample",
         *       "state": "kept",
         *       "stature": 1.74,
         *       "tags": {
         *         "body": "adult",
         *         "emotion": "sad",
         *         "set": "B",
         *         "speed": "slow",
         *         "synthetic": "yes"
         *       }
         *     }
         */
        ClipDetail: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /**
             * Source
             * @enum {string}
             */
            source: "sample" | "imported";
            /**
             * State
             * @enum {string}
             */
            state: "kept" | "to_confirm" | "retired";
            /** Tags */
            tags: {
                [key: string]: string;
            };
            /** Frames */
            frames: number;
            /** Frame Time */
            frame_time: number;
            /** Duration */
            duration: number;
            /** Cyclic */
            cyclic: boolean;
            /** Stature */
            stature: number;
            /** Poster Time */
            poster_time: number;
            /** Glb Url */
            glb_url: string;
            /** Figure Url */
            figure_url: string | null;
            /** Page Url */
            page_url: string;
            report: components["schemas"]["ImportReport"] | null;
        };
        /**
         * ClipList
         * @description The library.
         */
        ClipList: {
            /** Clips */
            clips: components["schemas"]["ClipView"][];
        };
        /**
         * ClipView
         * @description A clip of the library; times in seconds, stature in metres.
         * @example {
         *       "cyclic": true,
         *       "duration": 1.6,
         *       "figure_url": "/media/7d793037a0760186574b0282f2f435e77d793037a0760186574b0282f2f435e7.glb",
         *       "frame_time": 0.0333333,
         *       "frames": 49,
         *       "glb_url": "/media/5d41402abc4b2a76b9719d911017c5925d41402abc4b2a76b9719d911017c592.glb",
         *       "id": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "name": "set_b_sad_slow",
         *       "page_url": "/library/0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "poster_time": 0.8,
         *       "source": "sample",
         *       "state": "kept",
         *       "stature": 1.74,
         *       "tags": {
         *         "body": "adult",
         *         "emotion": "sad",
         *         "set": "B",
         *         "speed": "slow",
         *         "synthetic": "yes"
         *       }
         *     }
         */
        ClipView: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /**
             * Source
             * @enum {string}
             */
            source: "sample" | "imported";
            /**
             * State
             * @enum {string}
             */
            state: "kept" | "to_confirm" | "retired";
            /** Tags */
            tags: {
                [key: string]: string;
            };
            /** Frames */
            frames: number;
            /** Frame Time */
            frame_time: number;
            /** Duration */
            duration: number;
            /** Cyclic */
            cyclic: boolean;
            /** Stature */
            stature: number;
            /** Poster Time */
            poster_time: number;
            /** Glb Url */
            glb_url: string;
            /** Figure Url */
            figure_url: string | null;
            /** Page Url */
            page_url: string;
        };
        /**
         * Completion
         * @description Every answer has arrived.
         */
        Completion: {
            /**
             * State
             * @default complete
             * @constant
             */
            state: "complete";
            /** Completion Code */
            completion_code: string;
            /** Answers */
            answers: number;
        };
        /**
         * Counts
         * @description How far the participants are.
         *
         *     Attributes:
         *         under_way: not complete, with a sign of life (consent or answer) in the last half hour.
         *         left_early: not complete, without one; left_at: the clip each stopped at, counted from 1.
         *         answers: rows of the raw answers, practice and earlier revisions included.
         *         median_seconds: from consent to completion, over the complete.
         */
        Counts: {
            /** Complete */
            complete: number;
            /** Under Way */
            under_way: number;
            /** Left Early */
            left_early: number;
            /** Left At */
            left_at: number[];
            /** Withdrawn */
            withdrawn: number;
            /** Answers */
            answers: number;
            /** Median Seconds */
            median_seconds: number | null;
        };
        /**
         * ErrorDetail
         * @description What is wrong, where, and what to do.
         * @example {
         *       "code": "clip_not_found",
         *       "mend": "Look for it in the library; it may have been deleted.",
         *       "message": "There is no such clip."
         *     }
         */
        ErrorDetail: {
            /** Code */
            code: string;
            /** Message */
            message: string;
            /** Where */
            where?: {
                [key: string]: unknown;
            } | null;
            /** Mend */
            mend?: string | null;
        } & {
            [key: string]: unknown;
        };
        /**
         * ErrorResponse
         * @description Every answer of the API with a status of 400 or above.
         */
        ErrorResponse: {
            error: components["schemas"]["ErrorDetail"];
        };
        /**
         * ImportOptions
         * @description What a person says about a file instead of leaving it to be guessed.
         *
         *     Attributes:
         *         unit: metres for one unit of the file.
         *         up_axis: the file's axis that points up.
         *         roles: body role to the name of its joint; an empty name takes a guessed role away.
         *         drop_first_frame: leave out a calibration pose at the start.
         *         fill_gaps: replace missing numbers by values between their neighbours.
         *         root: which of several hierarchies to read, counted from 0.
         *         frame_time: seconds, where the file's is missing or wrong.
         * @example {
         *       "unit": 0.01,
         *       "up_axis": "z"
         *     }
         */
        ImportOptions: {
            /** Unit */
            unit?: number | null;
            /** Up Axis */
            up_axis?: ("x" | "y" | "z" | "-x" | "-y" | "-z") | null;
            /** Roles */
            roles?: {
                [key: string]: string;
            } | null;
            /**
             * Drop First Frame
             * @default false
             */
            drop_first_frame: boolean;
            /**
             * Fill Gaps
             * @default false
             */
            fill_gaps: boolean;
            /** Root */
            root?: number | null;
            /** Frame Time */
            frame_time?: number | null;
        };
        /**
         * ImportReport
         * @description What was found in a file, repaired and guessed.
         *
         *     Attributes:
         *         unit: metres for one unit of the file; stature and lowest_foot in metres.
         *         heading: radians, the way the motion faced before it was turned to +z.
         *         bake_error: metres, the largest deviation from joints whose positions moved in the file.
         */
        ImportReport: {
            /** Repairs */
            repairs: components["schemas"]["Note"][];
            /** Questions */
            questions: components["schemas"]["Note"][];
            /** Unit */
            unit: number;
            /** Unit Name */
            unit_name: string;
            /** Up Axis */
            up_axis: string;
            /** Stature */
            stature: number;
            /** Lowest Foot */
            lowest_foot: number;
            /** Heading */
            heading: number;
            /** Roles */
            roles: {
                [key: string]: string;
            };
            /** Missing Roles */
            missing_roles: string[];
            /** Joint Names */
            joint_names: string[];
            /** Frames */
            frames: number;
            /** Frame Time */
            frame_time: number;
            /** Duration */
            duration: number;
            /** Bake Error */
            bake_error: number;
            /**
             * @default {
             *       "drop_first_frame": false,
             *       "fill_gaps": false
             *     }
             */
            options: components["schemas"]["ImportOptions"];
        } & {
            [key: string]: unknown;
        };
        /**
         * Imported
         * @description A clip that waits for confirmation, or was there already, and its report.
         */
        Imported: {
            clip: components["schemas"]["ClipView"];
            report: components["schemas"]["ImportReport"];
            /**
             * Already There
             * @default false
             */
            already_there: boolean;
        };
        /**
         * Note
         * @description One line of an import report: what was repaired, or what a person should confirm.
         * @example {
         *       "line": 217,
         *       "text": "A tab separates two numbers",
         *       "where": "line 217"
         *     }
         */
        Note: {
            /** Text */
            text: string;
            /** Line */
            line?: number | null;
            /** Where */
            where?: string | null;
            /** Offer */
            offer?: string | null;
        };
        /**
         * PoleRow
         * @description One row of "Is every emotion seen?": a pole's best clip against its body's clips.
         *
         *     Attributes:
         *         mean, others: means toward the pole, of the best clip and of its comparison group.
         *         p_holm: Welch's p adjusted over all the poles.
         *         paired_t: over participants' means, the best clip less the mean of the group.
         */
        PoleRow: {
            /** Scale */
            scale: string;
            /** Pole */
            pole: string;
            clip: components["schemas"]["Clip"] | null;
            /** Mean */
            mean: number | null;
            /** Others */
            others: number | null;
            /** Difference */
            difference: number | null;
            /** T */
            t: number | null;
            /** Df */
            df: number | null;
            /** P */
            p: number | null;
            /** P Holm */
            p_holm: number | null;
            /** D */
            d: number | null;
            /** D Low */
            d_low: number | null;
            /** D High */
            d_high: number | null;
            /** Paired T */
            paired_t: number | null;
            /** Paired Df */
            paired_df: number | null;
            /** Paired P */
            paired_p: number | null;
            /** Sentence */
            sentence: string | null;
        };
        /**
         * ResponseView
         * @description The newest stored answer of a trial.
         */
        ResponseView: {
            /** Revision */
            revision: number;
            /** Answers */
            answers: {
                [key: string]: number;
            };
            /** Touched */
            touched: string[];
            /** Comment */
            comment: string;
        };
        /**
         * ScaleView
         * @description A bipolar axis as it is asked.
         */
        ScaleView: {
            /** Id */
            id: string;
            /** Left */
            left: string;
            /** Right */
            right: string;
        };
        /**
         * SessionView
         * @description A session as its page needs it; `next` is the first trial without an answer, or their number.
         *
         *     The trials of a withdrawn session are gone with its answers.
         */
        SessionView: {
            study: components["schemas"]["StudyView"];
            /**
             * State
             * @enum {string}
             */
            state: "active" | "complete" | "withdrawn";
            /** Trials */
            trials: components["schemas"]["TrialView"][];
            /** Responses */
            responses: {
                [key: string]: components["schemas"]["ResponseView"];
            };
            /** Next */
            next: number;
        };
        /**
         * StudyResults
         * @description All of the results page's numbers.
         *
         *     Attributes:
         *         needed: complete participants below which nothing is computed.
         *         participants: complete ones, whose answers are analysed.
         *         rule: which answers are analysed, in words.
         *         against: "others" compares a best clip with the other clips of its body, "all" with all.
         */
        StudyResults: {
            /** Slug */
            slug: string;
            /** Title */
            title: string;
            /** Study Hash */
            study_hash: string;
            /** Needed */
            needed: number;
            /** Participants */
            participants: number;
            /** Rule */
            rule: string;
            /**
             * Against
             * @enum {string}
             */
            against: "others" | "all";
            counts: components["schemas"]["Counts"];
            /** Steps */
            steps: string[];
            /** Clips */
            clips: components["schemas"]["Clip"][];
            /** Axes */
            axes: components["schemas"]["Axis"][];
            /** Poles */
            poles: components["schemas"]["PoleRow"][];
        };
        /**
         * StudyView
         * @description What a participant's page shows of the study.
         */
        StudyView: {
            /** Title */
            title: string;
            /** Question */
            question: string;
            /** Hint */
            hint: string;
            /** Scales */
            scales: components["schemas"]["ScaleView"][];
            /** Steps */
            steps: string[];
            /** Comment Label */
            comment_label: string;
            /** Comment Placeholder */
            comment_placeholder: string;
        };
        /**
         * TrialView
         * @description One clip to judge. Addresses are content hashes: they do not give the clip's name away.
         */
        TrialView: {
            /** Index */
            index: number;
            /** Glb Url */
            glb_url: string;
            /** Figure Url */
            figure_url: string | null;
            /** Cyclic */
            cyclic: boolean;
        };
        /**
         * ViewingRecord
         * @description How the clip was watched. Times in ms; what a browser cannot tell is left out.
         */
        ViewingRecord: {
            /** Plays */
            plays?: number | null;
            /** Viewing Ms */
            viewing_ms?: number | null;
            /** Camera Moves */
            camera_moves?: number | null;
            /** Hidden Ms */
            hidden_ms?: number | null;
            /** Blur Count */
            blur_count?: number | null;
            /** Dropped Frames */
            dropped_frames?: number | null;
            /** Tier */
            tier?: string | null;
            viewport?: components["schemas"]["Viewport"] | null;
        };
        /**
         * Viewport
         * @description Size of the page in CSS pixels.
         */
        Viewport: {
            /** Width */
            width: number;
            /** Height */
            height: number;
            /** Pixel Ratio */
            pixel_ratio: number;
        };
    };
    responses: never;
    parameters: never;
    requestBodies: never;
    headers: never;
    pathItems: never;
}
export type $defs = Record<string, never>;
export interface operations {
    list_clips: {
        parameters: {
            query?: {
                /** @description Words of name or tags */
                query?: string;
                /** @description `emotion:sad`, or a value alone */
                tag?: string[];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipList"];
                };
            };
            /** @description A researcher must sign in first */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    download_bvh: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description A researcher must sign in first */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    download_glb: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description A researcher must sign in first */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipDetail"];
                };
            };
            /** @description A researcher must sign in first */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    delete_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description A researcher must sign in first */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    correct_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ImportOptions"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Imported"];
                };
            };
            /** @description A researcher must sign in first */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    confirm_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipDetail"];
                };
            };
            /** @description A researcher must sign in first */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    import_motion: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "multipart/form-data": components["schemas"]["Body_import_motion"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Imported"];
                };
            };
            /** @description A researcher must sign in first */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_session: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                token: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SessionView"];
                };
            };
            /** @description The personal link is not known. */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    record_response: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                token: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Answer"];
            };
        };
        responses: {
            /** @description The same answer was stored before. */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AnswerReceipt"];
                };
            };
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AnswerReceipt"];
                };
            };
            /** @description The personal link is not known. */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description It contradicts what is stored. */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    complete: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                token: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Completion"];
                };
            };
            /** @description The personal link is not known. */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description It contradicts what is stored. */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    read_results: {
        parameters: {
            query?: {
                against?: "others" | "all";
            };
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudyResults"];
                };
            };
            /** @description A researcher must sign in first. */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description There is no such study. */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
}
